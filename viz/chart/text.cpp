#include "viz/chart/text.h"

#include "viz/chart/font.h"

namespace furnas {
namespace {

/// Number of bytes of the UTF-8 letter that begins at `at`.
std::size_t letter_length(const std::string& text, std::size_t at) {
  std::size_t length = 1;
  while (at + length < text.size() && (static_cast<unsigned char>(text[at + length]) & 0xC0U) == 0x80U)
    ++length;
  return length;
}

}  // namespace

std::vector<TextRun> text_runs(const std::string& text) {
  constexpr double small = 0.7, raised = 0.38, lowered = -0.18;
  std::vector<TextRun> runs;
  std::string plain;
  const auto end_plain = [&] {
    if (!plain.empty()) runs.push_back({plain});
    plain.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    const bool shifted = (text[at] == '_' || text[at] == '^') && at + 1 < text.size();
    if (!shifted) {
      plain += text[at++];
      continue;
    }
    const double lift = text[at] == '^' ? raised : lowered;
    ++at;
    const std::size_t close = text[at] == '{' ? text.find('}', at) : std::string::npos;
    const bool braces = close != std::string::npos;
    const std::size_t begin = braces ? at + 1 : at;
    const std::size_t length = braces ? close - begin : letter_length(text, at);
    end_plain();
    runs.push_back({text.substr(begin, length), small, lift});
    at = braces ? close + 1 : begin + length;
  }
  end_plain();
  return runs;
}

double width_of_text(const std::string& text, double size) {
  double width = 0;
  for (const TextRun& run : text_runs(text)) width += text_width(run.text, run.size * size);
  return width;
}

void write(Canvas& canvas, const Spot& spot, const std::string& text, double size, const TextPlace& place) {
  double along = -0.5 * static_cast<int>(place.across) * width_of_text(text, size);
  const double below = 0.5 * static_cast<int>(place.along) * capital_height * size;
  for (const TextRun& run : text_runs(text)) {
    const double across = run.lift * size - below;
    const Spot left =
        place.upwards ? Spot{spot.x - across, spot.y + along} : Spot{spot.x + along, spot.y + across};
    canvas.text(left, run.text, run.size * size, place.upwards);
    along += text_width(run.text, run.size * size);
  }
}

}  // namespace furnas
