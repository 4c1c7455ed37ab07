#include "viz/picture.h"

#include <fmt/format.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/base/require.h"
#include "viz/ambient_occlusion.h"
#include "viz/force_chains.h"
#include "viz/offscreen.h"
#include "viz/palette.h"
#include "viz/picture_key.h"
#include "viz/scene.h"
#include "viz/visible.h"

namespace furnas {
namespace {

/// Four renderings are averaged. Each is shifted by a fraction of a pixel, which smooths the edges. Each also
/// has a different reach of the ambient occlusion.
constexpr std::array<std::array<double, 2>, 4> shifts{
    {{-0.125, -0.375}, {0.375, -0.125}, {0.125, 0.375}, {-0.375, 0.125}}};

/// The reach of the ambient occlusion in each rendering [d_s].
using Reaches = std::array<double, shifts.size()>;

/// The reach grows from one rendering to the next: from the size of gaps between small spheres to that of
/// gaps between large spheres, but it is at least a few pixels [d_s].
Reaches reaches(const std::vector<Sphere>& spheres, double pixel) {
  const auto [small, large] = std::minmax_element(
      spheres.begin(), spheres.end(), [](const Sphere& a, const Sphere& b) { return a.radius < b.radius; });
  const double from = std::max(1.2 * small->radius, 6 * pixel),
               to = std::max(3.0 * large->radius, 12 * pixel);
  Reaches result;
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = from * std::pow(to / from, double(k) / double(result.size() - 1));
  return result;
}

/// The mean of several renderings.
class Average {
 public:
  explicit Average(std::size_t pixels) : sums_(4 * pixels) {}

  void add(const vtkUnsignedCharArray& pixels) {
    for (std::size_t k = 0; k < sums_.size(); k += 4) {
      const auto at = [&](std::size_t c) {
        return pixels.GetValue(static_cast<vtkIdType>(k) + static_cast<vtkIdType>(c));
      };
      if (at(3) == 0) continue;
      for (std::size_t c = 0; c < 4; ++c) sums_[k + c] = static_cast<std::uint16_t>(sums_[k + c] + at(c));
    }
    ++count_;
  }

  std::vector<std::uint8_t> mean(bool transparent) const {
    std::vector<std::uint8_t> rgba(sums_.size());
    const double full = 255.0 * count_;
    for (std::size_t k = 0; k < sums_.size(); k += 4) {
      const double cover = sums_[k + 3] / full;
      for (std::size_t c = 0; c < 3; ++c) {
        const double body = sums_[k + c] / full;
        const double value =
            transparent ? (cover > 0 ? body / cover : 0) : body + (1 - cover) * background_colour[c];
        rgba[k + c] = static_cast<std::uint8_t>(std::lround(255 * std::min(value, 1.0)));
      }
      rgba[k + 3] = transparent ? static_cast<std::uint8_t>(std::lround(255 * cover)) : 255;
    }
    return rgba;
  }

 private:
  std::vector<std::uint16_t> sums_;
  int count_ = 0;
};

Cell repeated(const Cell& cell, const std::array<int, 3>& times) {
  Cell all = cell;
  all.edges.xx *= times[0];
  all.edges.xy *= times[1], all.edges.yy *= times[1];
  all.edges.xz *= times[2], all.edges.yz *= times[2], all.edges.zz *= times[2];
  return all;
}

/// Everything that is drawn, including hidden spheres.
Drawing drawing_of(const Packing& packing, const PictureOptions& options) {
  const bool chains = options.style == PictureStyle::chains;
  Drawing drawing;
  const Coloured colours = coloured(packing, options.colouring, options.backbone_threshold);
  drawing.spheres = spheres_of(packing, colours.particles, options.times, options.slice);
  if (drawing.spheres.empty()) throw InputError("cannot draw: the slice holds the centre of no particle");
  if (options.cell) drawing.frame = CellFrame{repeated(packing.cell, options.times)};
  if (!chains) return drawing;
  const double strongest = strong_force(packing);
  if (!(strongest > 0)) throw InputError("cannot draw chains: the packing has no contacts");
  drawing.chains = force_chains(packing, strongest);
  return drawing;
}

View view_of(const Packing& packing, const Drawing& drawing, const PictureOptions& options) {
  const double aspect = double(options.width) / options.height;
  if (options.room == 0) return view_of(drawing, aspect, options.turn);
  ViewFit fit(aspect, options.turn);
  fit.add(repeated(packing.cell, options.times).edges * Vec3<double>{0.5, 0.5, 0.5}, options.room);
  return fit.view();
}

/// The mean of several renderings of opaque bodies.
std::vector<std::uint8_t> draw(OffscreenWindow& offscreen, const Drawing& drawing, const View& view,
                               const PictureOptions& options, const Reaches& reach) {
  const auto renderer = scene_of(drawing, view);
  offscreen.vtk().AddRenderer(renderer);
  vtkSmartPointer<vtkSSAOPass> occlusion;
  if (options.ambient_occlusion) occlusion = add_ambient_occlusion(*renderer);

  Average average(std::size_t(options.width) * std::size_t(options.height));
  vtkNew<vtkUnsignedCharArray> pixels;
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    renderer->GetActiveCamera()->SetWindowCenter(2 * shifts[k][0] / options.width,
                                                 2 * shifts[k][1] / options.height);
    if (occlusion) {
      occlusion->SetRadius(reach[k]);
      occlusion->SetBias(0.03 * reach[k]);
    }
    offscreen.vtk().Render();
    offscreen.vtk().GetRGBACharPixelData(0, 0, options.width - 1, options.height - 1, 0, pixels);
    average.add(*pixels);
  }
  if (!offscreen.complaint().empty()) throw std::runtime_error("cannot draw: " + offscreen.complaint());
  offscreen.vtk().RemoveRenderer(renderer);
  return average.mean(options.transparent);
}

/// Draws `veil` over `picture` with a low opacity.
void lay_over(std::vector<std::uint8_t>& picture, const std::vector<std::uint8_t>& veil) {
  constexpr double opacity = 0.15;
  for (std::size_t k = 0; k < picture.size(); k += 4) {
    const double over = opacity * veil[k + 3] / 255, under = (1 - over) * picture[k + 3] / 255;
    if (over + under == 0) continue;
    for (std::size_t c = k; c < k + 3; ++c)
      picture[c] =
          static_cast<std::uint8_t>(std::lround((over * veil[c] + under * picture[c]) / (over + under)));
    picture[k + 3] = static_cast<std::uint8_t>(std::lround(255 * (over + under)));
  }
}

/// The legend of the colours; for chains, of the colours of the tubes.
ColourKey legend_of(const Packing& packing, const PictureOptions& options) {
  if (options.style != PictureStyle::chains)
    return coloured(packing, options.colouring, options.backbone_threshold).legend;
  const double strongest = strong_force(packing);
  return {.title = "normal force [k_n d_s]", .scale = ColourScale{1e-2 * strongest, strongest, true}};
}

/// Makes opaque pixels as transparent as they can be without changing their look on a white background.
void take_out_white(Pixels& picture) {
  for (std::size_t k = 0; k < picture.rgba.size(); k += 4) {
    std::uint8_t* const pixel = &picture.rgba[k];
    const int white = std::min({pixel[0], pixel[1], pixel[2]}), opacity = 255 - white;
    for (int c = 0; c < 3 && opacity > 0; ++c)
      pixel[c] = static_cast<std::uint8_t>(255 * (pixel[c] - white) / opacity);
    pixel[3] = static_cast<std::uint8_t>(opacity);
  }
}

/// The packing without a legend; it fills the whole frame.
Pixels render_packing(const Packing& packing, const PictureOptions& options) {
  OffscreenWindow offscreen(options.width, options.height);
  Drawing drawing = drawing_of(packing, options);
  const View view = view_of(packing, drawing, options);
  const Reaches reach = reaches(drawing.spheres, view.pixel(view.nearest, options.height));
  const auto chains = std::exchange(drawing.chains, {});
  drawing.spheres = visible(drawing.spheres, view, options.width, options.height);
  std::vector<std::uint8_t> picture = draw(offscreen, drawing, view, options, reach);
  if (chains) {
    const std::vector<std::uint8_t> veil = std::move(picture);
    drawing.spheres.clear();
    drawing.chains = chains;
    picture = draw(offscreen, drawing, view, options, reach);
    lay_over(picture, veil);
  }
  return {options.width, options.height, std::move(picture)};
}

}  // namespace

Pixels render(const Packing& packing, const PictureOptions& options) {
  if (packing.size() == 0) throw InputError("cannot draw: the packing has no particles");
  const int strip = options.key ? height_of_key(options.width) : 0;
  if (strip == 0 || 2 * strip > options.height) return render_packing(packing, options);
  PictureOptions above = options;
  above.height -= strip;
  Pixels picture = drawn_key(legend_of(packing, options), options.width);
  const Pixels drawn = render_packing(packing, above);
  if (options.transparent) take_out_white(picture);
  picture.height = options.height;
  picture.rgba.insert(picture.rgba.end(), drawn.rgba.begin(), drawn.rgba.end());
  return picture;
}

void render_picture(const Packing& packing, const std::filesystem::path& path,
                    const PictureOptions& options) {
  write_picture(render(packing, options), path, options.transparent);
}

double room_of(const Packing& packing, const std::array<int, 3>& times) {
  const Vec3<double> middle = repeated(packing.cell, times).edges * Vec3<double>{0.5, 0.5, 0.5};
  double room = norm(middle);
  // The copies at the corners of the block are the farthest from the middle, so only the first and last copy
  // along each edge are visited.
  const auto to_last = [&](std::size_t axis) { return std::max(times[axis] - 1, 1); };
  for (int a = 0; a < times[0]; a += to_last(0))
    for (int b = 0; b < times[1]; b += to_last(1))
      for (int c = 0; c < times[2]; c += to_last(2)) {
        const Vec3<double> from_middle =
            packing.cell.edges * Vec3<double>{double(a), double(b), double(c)} - middle;
        for (std::size_t k = 0; k < packing.size(); ++k)
          room = std::max(room, norm(packing.position(k) + from_middle) + packing.radius[k]);
      }
  return room;
}

std::string key_of(const Packing& packing, const PictureOptions& options) {
  std::string key = coloured(packing, options.colouring, options.backbone_threshold).key;
  if (options.style == PictureStyle::chains)
    key +=
        fmt::format("; tubes: normal force from {:.2g} (dark blue) to {:.2g} k_n d_s (yellow), logarithmic",
                    1e-2 * strong_force(packing), strong_force(packing));
  return key;
}

}  // namespace furnas
