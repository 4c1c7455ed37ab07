#include "io/packing_csv.h"

#include <span>
#include <string>
#include <vector>

#include "io/csv.h"
#include "io/packing_fields.h"
#include "io/species_type.h"
#include "io/text_writer.h"

namespace furnas {
namespace {

void write_header(AtomicFile& file, std::span<const OutputField> columns) {
  std::vector<std::string> names;
  for (const OutputField& column : columns) names.emplace_back(column.name);
  file.write(csv_row(names));
}

}  // namespace

void write_packing_csv(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  write_header(file, packing_csv_fields());
  std::vector<std::string> names = names_of_types(packing);
  for (std::string& name : names) name = csv_cell(name);
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const std::int32_t type = type_of(packing, k);
    print(file, "{},{},{},{},{:,},{:,},{:,},{:,},{:,},{}\n", packing.id(k),
          names.at(static_cast<std::size_t>(type) - 1), packing.radius[k], packing.mass[k],
          packing.position(k) + packing.labels.origin, packing.velocity[k], packing.spin[k], packing.force[k],
          packing.torque[k], type);
  }
  file.commit();
}

void write_contacts_csv(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  write_header(file, contacts_csv_fields());
  for (const Contact& c : packing.contacts)
    print(file, "{},{},{:,},{},{:,},{:,},{:d}\n", packing.id(c.i), packing.id(c.j), c.branch, c.overlap,
          c.force, c.history, c.sliding);
  file.commit();
}

}  // namespace furnas
