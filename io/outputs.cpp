#include "io/outputs.h"

#include "io/extended_xyz.h"
#include "io/lammps_dump.h"
#include "io/vtp_packing.h"

namespace furnas {
namespace {

template <void (*write)(const Packing&, const std::filesystem::path&)>
void packing_as(const RunRecord& run, const std::filesystem::path& path) {
  write(run.packing, path);
}

// clang-format off
constexpr Output table[] = {
    {"result.json",        [](const RunRecord& run, const std::filesystem::path& path) { write_result(run.result, run.resolved_case, path); }},
    {"packing.vtp",        packing_as<write_vtp>},
    {"contacts.vtp",       packing_as<write_contacts_vtp>},
    {"cell.vtp",           packing_as<write_cell_vtp>},
    {"packing.extxyz",     packing_as<write_extended_xyz>},
    {"packing.lammpstrj",  packing_as<write_lammps_dump>},
};
// clang-format on

}  // namespace

std::span<const Output> outputs() { return table; }

void write_outputs(const RunRecord& run, const std::filesystem::path& folder) {
  for (const Output& output : outputs()) output.write(run, folder / output.file);
}

}  // namespace furnas
