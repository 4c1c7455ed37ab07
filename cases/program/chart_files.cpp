#include "cases/program/chart_files.h"

#include <fmt/format.h>

#include <ostream>

#include "engine/base/require.h"

namespace furnas {

std::vector<std::string> write_chart(const Chart& chart, const std::filesystem::path& folder,
                                     const std::string& name, Console console) {
  std::vector<std::string> written{name + ".svg"};
  render_svg(chart, folder / written.back());
  try {
    render_png(chart, folder / (name + ".png"));
    written.push_back(name + ".png");
  } catch (const InputError& error) {
    console.err << fmt::format("furnas: no {}.png: {}\n", name, error.what());
  }
  return written;
}

}  // namespace furnas
