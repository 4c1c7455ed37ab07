#include "io/diameters_file.h"

#include <algorithm>
#include <string_view>

#include "io/text_reader.h"

namespace furnas {

DiameterList read_diameters(const std::filesystem::path& path) {
  TextReader reader(path);
  DiameterList list;
  while (reader.next_line()) {
    const std::vector<std::string_view> words = reader.words('#');
    if (words.empty()) continue;
    if (words.size() > 1) reader.fail("more than one number in a line; allowed: one diameter");
    list.diameters.push_back(reader.positive(words[0], "diameter"));
  }
  if (list.diameters.empty())
    reader.fail_at(0, "contains no diameter; allowed: text with one diameter per line");
  list.unit = *std::min_element(list.diameters.begin(), list.diameters.end());
  for (double& d : list.diameters) d /= list.unit;
  return list;
}

}  // namespace furnas
