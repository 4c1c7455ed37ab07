#include "viz/picture.h"

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
#include <vector>

#include "engine/base/require.h"
#include "viz/ambient_occlusion.h"
#include "viz/offscreen.h"
#include "viz/palette.h"
#include "viz/scene.h"

namespace furnas {
namespace {

/// Renderings that are averaged; each is shifted by a part of a pixel, which smooths the edges, and
/// takes another reach of the ambient occlusion.
constexpr std::array<std::array<double, 2>, 4> shifts{
    {{-0.125, -0.375}, {0.375, -0.125}, {0.125, 0.375}, {-0.375, 0.125}}};

/// How far from a surface others shade it, from the gaps between small spheres to those between large
/// ones, and never below what a few pixels can show [d_s].
std::array<double, shifts.size()> reaches(const Packing& packing, double pixel) {
  const auto [small, large] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  const double from = std::max(1.2 * *small, 6 * pixel), to = std::max(3.0 * *large, 12 * pixel);
  std::array<double, shifts.size()> result;
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
      const auto at = [&](std::size_t c) { return pixels.GetValue(static_cast<vtkIdType>(k + c)); };
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

}  // namespace

Pixels render(const Packing& packing, const PictureOptions& options) {
  if (packing.size() == 0) throw InputError("cannot draw: the packing has no particles");
  OffscreenWindow offscreen(options.width, options.height);
  const View view = view_of(packing, double(options.width) / options.height, options.cell);
  const auto renderer = scene_of(packing, view, options.cell);
  offscreen.vtk().AddRenderer(renderer);

  const auto reach = reaches(packing, view.pixel(view.nearest, options.height));
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
  return {options.width, options.height, average.mean(options.transparent)};
}

void render_png(const Packing& packing, const std::filesystem::path& path, const PictureOptions& options) {
  write_png(render(packing, options), path, options.transparent);
}

}  // namespace furnas
