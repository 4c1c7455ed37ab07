#include "io/species_type.h"

#include <array>

#include "engine/state/species.h"

namespace furnas {
namespace {

constexpr std::array<std::string_view, 118> elements{
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",  "Cl",
    "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge", "As", "Se",
    "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd", "In", "Sn", "Sb",
    "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd", "Tb", "Dy", "Ho", "Er",
    "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl", "Pb", "Bi", "Po", "At",
    "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm", "Bk", "Cf", "Es", "Fm", "Md", "No",
    "Lr", "Rf", "Db", "Sg", "Bh", "Hs", "Mt", "Ds", "Rg", "Cn", "Nh", "Fl", "Mc", "Lv", "Ts", "Og"};

}  // namespace

std::int32_t type_count(const Packing& p) {
  std::int32_t most = 1;
  for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, type_of(p, k));
  return std::max(most, static_cast<std::int32_t>(p.labels.names.size()));
}

std::string name_of_type(const Packing& p, std::int32_t type) {
  const auto place = static_cast<std::size_t>(type) - 1;
  if (place < p.labels.names.size()) return p.labels.names[place];
  if (!p.labels.type.empty() || type > 2) return std::to_string(type);
  if (is_polydisperse(p)) return "sphere";
  return std::string(name_of(type == 1 ? Species::large : Species::small));
}

std::vector<std::string> names_of_types(const Packing& p) {
  const std::int32_t types = type_count(p);
  std::vector<std::string> names;
  for (std::int32_t type = 1; type <= types; ++type) names.push_back(name_of_type(p, type));
  return names;
}

std::string_view element_of(const Packing& p, std::size_t k) {
  const std::int32_t type = type_of(p, k);
  const std::string name = name_of_type(p, type);
  if (const auto found = std::find(elements.begin(), elements.end(), name); found != elements.end())
    return *found;
  if (type <= 2) return p.species[k] == Species::large ? "Ag" : "Au";
  return elements[(static_cast<std::size_t>(type) - 3) % elements.size()];
}

}  // namespace furnas
