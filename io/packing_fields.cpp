#include "io/packing_fields.h"

namespace furnas {
namespace {

constexpr auto whole = VtpField::Place::field;
constexpr auto point = VtpField::Place::point;
constexpr auto line = VtpField::Place::cell;

constexpr std::string_view length = "d_s", mass = "rho d_s^3", force = "k_n d_s", torque = "k_n d_s^2";
constexpr std::string_view time = "(rho d_s^3/k_n)^(1/2)", rate = "(k_n/(rho d_s^3))^(1/2)",
                           velocity = "d_s (k_n/(rho d_s^3))^(1/2)";

const VtpField vtp[] = {
    {whole, {"cell", length, "packing", "upper triangle, row by row: its columns are the edges of the cell"}},
    {whole, {"rate", rate, "packing", "strain rate of the cell, row by row; positive when it grows"}},
    {whole, {"TimeValue", time, "packing", "simulated time"}},
    {whole, {"step", "", "packing", "time step"}},
    {whole, {"origin", length, "packing", "corner of the cell"}},
    {point, {"id", "", "each particle", "1, 2, 3, ..., or the id in the start file"}},
    {point,
     {"type", "", "each particle", "the type in the start file, 1, 2, 3, ...; without one 1 large, 2 small"}},
    {point, {"species", "", "each particle", "0 large, 1 small"}},
    {point, {"radius", length, "each particle", "half the diameter"}},
    {point, {"mass", mass, "each particle", "of the sphere, at density rho"}},
    {point, {"image", "", "each particle", "cells crossed along each edge; the points are within the cell"}},
    {point, {"velocity", velocity, "each particle", "peculiar: without the flow of the cell"}},
    {point, {"spin", rate, "each particle", "angular velocity"}},
    {point, {"force", force, "each particle", "net force of its contacts"}},
    {point, {"torque", torque, "each particle", "net torque of its contacts about its centre"}},
    {point, {"coordination", "", "each particle", "its contacts, live or not"}},
};

const VtpField contacts[] = {
    {line, {"i", "", "each contact", "id of the particle at the first end of the line"}},
    {line, {"j", "", "each contact", "id of the particle whose image, touched by i, lies at the second end"}},
    {line, {"force", force, "each contact", "force on i; the force on j is the opposite"}},
    {line,
     {"normal_force", force, "each contact",
      "component along the normal, which points from j to i; positive when it pushes i and j apart"}},
    {line,
     {"tangential_force", force, "each contact", "size of the component across the normal, never negative"}},
    {line, {"overlap", length, "each contact", "R_i + R_j - distance of the centres, positive"}},
    {line, {"sliding", "", "each contact", "1 at the Coulomb limit, else 0"}},
};

const OutputField xyz[] = {
    {"species", "", "each particle",
     "a chemical element that stands for the type, for programs that need one"},
    {"species_name", "", "each particle",
     "large, small, sphere in a polydisperse packing, or the name of the type in the start file"},
    {"id", "", "each particle", "1, 2, 3, ..., or the id in the start file"},
    {"pos", length, "each particle", "centre, within the cell"},
    {"image", "", "each particle", "cells crossed along each edge"},
    {"radius", length, "each particle", "half the diameter"},
    {"mass", mass, "each particle", "of the sphere, at density rho"},
    {"velo", velocity, "each particle", "peculiar: without the flow of the cell"},
    {"force", force, "each particle", "net force of its contacts"},
    {"angular_velocity", rate, "each particle", "spin"},
    {"torque", torque, "each particle", "net torque of its contacts about its centre"},
};

const OutputField csv[] = {
    {"id", "", "each particle", "1, 2, 3, ..., or the id in the start file"},
    {"species", "", "each particle",
     "large, small, sphere in a polydisperse packing, or the name of the type in the start file"},
    {"radius", length, "each particle", "half the diameter"},
    {"mass", mass, "each particle", "of the sphere, at density rho"},
    {"x", length, "each particle", "centre, within the cell"},
    {"y", length, "each particle", "the same"},
    {"z", length, "each particle", "the same"},
    {"velocity_x", velocity, "each particle", "peculiar: without the flow of the cell"},
    {"velocity_y", velocity, "each particle", "the same"},
    {"velocity_z", velocity, "each particle", "the same"},
    {"spin_x", rate, "each particle", "angular velocity"},
    {"spin_y", rate, "each particle", "the same"},
    {"spin_z", rate, "each particle", "the same"},
    {"force_x", force, "each particle", "net force of its contacts"},
    {"force_y", force, "each particle", "the same"},
    {"force_z", force, "each particle", "the same"},
    {"torque_x", torque, "each particle", "net torque of its contacts about its centre"},
    {"torque_y", torque, "each particle", "the same"},
    {"torque_z", torque, "each particle", "the same"},
    {"type", "", "each particle", "the type in the start file, 1, 2, 3, ...; without one 1 large, 2 small"},
};

const OutputField contacts_table[] = {
    {"i", "", "each contact", "id of a particle"},
    {"j", "", "each contact", "id of the particle whose image i touches"},
    {"branch_x", length, "each contact", "from the centre of that image of j to the centre of i"},
    {"branch_y", length, "each contact", "the same"},
    {"branch_z", length, "each contact", "the same"},
    {"overlap", length, "each contact", "R_i + R_j - distance of the centres, positive"},
    {"force_x", force, "each contact", "force on i; the force on j is the opposite"},
    {"force_y", force, "each contact", "the same"},
    {"force_z", force, "each contact", "the same"},
    {"history_x", length, "each contact", "tangential displacement of i against j"},
    {"history_y", length, "each contact", "the same"},
    {"history_z", length, "each contact", "the same"},
    {"sliding", "", "each contact", "1 at the Coulomb limit, else 0"},
};

}  // namespace

std::span<const VtpField> packing_vtp_fields() { return vtp; }
std::span<const VtpField> contacts_vtp_fields() { return contacts; }
std::span<const OutputField> extended_xyz_fields() { return xyz; }
std::span<const OutputField> packing_csv_fields() { return csv; }
std::span<const OutputField> contacts_csv_fields() { return contacts_table; }

}  // namespace furnas
