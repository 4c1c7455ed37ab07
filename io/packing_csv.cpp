#include "io/packing_csv.h"

#include "io/packing_fields.h"
#include "io/species_type.h"
#include "io/text_writer.h"

namespace furnas {

void write_packing_csv(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  file.write(
      "id,species,radius,mass,x,y,z,velocity_x,velocity_y,velocity_z,spin_x,spin_y,spin_z,"
      "force_x,force_y,force_z,torque_x,torque_y,torque_z,type\n");
  for (std::size_t k = 0; k < packing.size(); ++k)
    print(file, "{},{},{},{},{:,},{:,},{:,},{:,},{:,},{}\n", packing.id(k),
          name_of_type(packing, type_of(packing, k)), packing.radius[k], packing.mass[k],
          packing.position(k) + packing.labels.origin, packing.velocity[k], packing.spin[k], packing.force[k],
          packing.torque[k], type_of(packing, k));
  file.commit();
}

void write_contacts_csv(const Packing& packing, const std::filesystem::path& path) {
  AtomicFile file(path);
  const char* comma = "";
  for (const OutputField& field : contacts_csv_fields()) {
    print(file, "{}{}", comma, field.name);
    comma = ",";
  }
  print(file, "\n");
  for (const Contact& c : packing.contacts)
    print(file, "{},{},{:,},{},{:,},{:,},{:d}\n", packing.id(c.i), packing.id(c.j), c.branch, c.overlap,
          c.force, c.history, c.sliding);
  file.commit();
}

}  // namespace furnas
