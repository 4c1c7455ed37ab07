#include "io/outputs.h"

#include "io/formats.h"
#include "io/vtp_packing.h"

namespace furnas {
namespace {

template <void (*write)(const Packing&, const std::filesystem::path&)>
void packing_as(const RunRecord& run, const std::filesystem::path& path) {
  write(run.packing, path);
}

void packing_in_format(const char* format, const RunRecord& run, const std::filesystem::path& path) {
  write_packing(run.packing, format, path);
}

// clang-format off
constexpr Output table[] = {
    {"result.json",        [](const RunRecord& run, const std::filesystem::path& path) { write_result(run.result, run.resolved_case, path); }},
    {"packing.vtp",        packing_as<write_vtp>},
    {"contacts.vtp",       packing_as<write_contacts_vtp>},
    {"cell.vtp",           packing_as<write_cell_vtp>},
    {"packing.extxyz",     [](const RunRecord& run, const std::filesystem::path& path) { packing_in_format("extxyz", run, path); }},
    {"packing.lammpstrj",  [](const RunRecord& run, const std::filesystem::path& path) { packing_in_format("lammps-dump", run, path); }},
};
// clang-format on

}  // namespace

std::span<const Output> outputs() { return table; }

void write_outputs(const RunRecord& run, const std::filesystem::path& folder) {
  for (const Output& output : outputs()) output.write(run, folder / output.file);
}

}  // namespace furnas
