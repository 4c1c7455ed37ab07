#include "viz/chart.h"

#include "io/atomic_file.h"
#include "viz/chart/drawing.h"
#include "viz/chart/pixel_canvas.h"
#include "viz/chart/svg_canvas.h"

namespace furnas {

Series steps(std::string name, const std::vector<double>& edges, const std::vector<double>& heights,
             const Colour& colour, LineStyle line) {
  Series s{std::move(name), {}, {}, {}, colour, line};
  for (std::size_t k = 0; k < heights.size(); ++k) {
    s.x.insert(s.x.end(), {edges[k], edges[k + 1]});
    s.y.insert(s.y.end(), {heights[k], heights[k]});
  }
  return s;
}

Pixels render(const Chart& chart) {
  return painted(chart.width, chart.height, [&](Canvas& canvas) { draw(chart, canvas); });
}

void render_png(const Chart& chart, const std::filesystem::path& path) {
  write_png(render(chart), path, false);
}

void render_svg(const Chart& chart, const std::filesystem::path& path) {
  SvgCanvas canvas(chart.width, chart.height);
  draw(chart, canvas);
  write_file(path, canvas.file());
}

}  // namespace furnas
