#include "cases/packing_source.h"

#include <filesystem>

#include "cases/recording.h"
#include "io/formats.h"

namespace furnas {

Packing packing_from(const std::string& source) {
  if (std::filesystem::is_directory(source)) return Checkpoints::read_newest(source).packing;
  return read_packing(source);
}

}  // namespace furnas
