#include "engine/certificate/certify.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <optional>

#include "engine/certificate/backbone.h"
#include "engine/certificate/constraints.h"
#include "engine/certificate/growth.h"
#include "engine/certificate/modes.h"
#include "engine/certificate/moduli.h"
#include "engine/certificate/statics.h"
#include "engine/state/validate.h"

namespace furnas {
namespace {

/// In a fixed cell every positive pressure is accepted; smaller values than this count as zero.
constexpr double least_pressure = 1e-12;

double real(std::int64_t count) { return static_cast<double>(count); }

/// The rule of the backbone: every overlap counts as a spring, however weak. Without friction at least four
/// contacts are needed to hold a sphere, and they must enclose it. With friction two sticking contacts are
/// enough.
CoreRule core_rule(const Springs& springs) {
  return {.force_share = 0, .least_contacts = springs.friction() > 0 ? 2 : 4, .by_constraints = true};
}

Part backbone_part(const ContactNetwork& network, const std::vector<Species>& species,
                   const Backbone& backbone) {
  const Percolation across = percolation(backbone);
  Part part;
  part.name = "backbone";
  part.asks = "Is there a set of particles with z_min contacts each that spans the cell in all directions?";
  part.findings = {
      at_least("particles of the backbone, every overlap counted", real(std::ssize(backbone.particles)), 1),
      at_least("directions in which it meets its own image", across.directions, 3),
      at_most("connected pieces", real(across.pieces), 1),
      at_most("members with fewer than z_min contacts, rattlers with as many", real(backbone.rule_breaks),
              0)};
  for (const double share : {0.001, 0.01, 0.1})
    for (const int least : {2, 3, 4})
      part.findings.push_back(
          told("backbone with z_min " + std::to_string(least) + ", F_n > " +
                   std::to_string(share).substr(0, 5) + " of its mean",
               real(std::ssize(find_backbone(network, species, {share, least}).particles))));
  part.note =
      "The other parts use the first of these sets: a weak contact is a spring like any other, and the "
      "spheres "
      "that stand on three strong contacts and a weak one carry as much as their neighbours.";
  return part;
}

/// Checks the force balance; also sets `balance`.
Part balance_part(const ContactNetwork& network, const Backbone& backbone, const CertificateTerms& terms,
                  Balance& balance) {
  const Imbalance found = imbalance(network, backbone);
  Part part;
  part.name = "force balance";
  part.asks = "Do the static forces and torques on every member of the backbone cancel?";
  part.findings = {
      at_most("mean |net force|/mean contact force", found.mean_force, terms.imbalance),
      at_most("largest |net force|/load of the particle", found.largest_force, terms.single_imbalance),
      at_most("mean |net torque|/(mean contact force R)", found.mean_torque, terms.imbalance),
      at_most("largest |net torque|/(load R)", found.largest_torque, terms.single_imbalance)};
  if (part.passed()) {
    balance = found.mean_force <= terms.tight_imbalance ? Balance::tight : Balance::loose;
    part.note = to_string(balance);
  }
  return part;
}

Part stress_part(const ContactNetwork& network, const CertificateTerms& terms) {
  const Eigen::Matrix3d p = static_stress(network);
  const Eigen::Matrix3d symmetric = 0.5 * (p + p.transpose());
  Part part;
  part.name = "stress";
  part.asks = "Do the contacts carry the applied pressure, in every component that the cell can answer to?";
  if (terms.cell.freedom == CellFreedom::fixed) {
    part.findings = {at_least("pressure [k_n/d_s]", p.trace() / 3, least_pressure)};
    part.note = "The cell is fixed: no pressure is applied.";
    return part;
  }
  const bool shape = terms.cell.freedom != CellFreedom::cubic;
  const bool shears = terms.cell.freedom == CellFreedom::triclinic;
  const auto component = [&](const char* name, double error, bool answers) {
    part.findings.push_back(answers ? at_most(name, std::abs(error), terms.stress_error) : told(name, error));
  };
  const Eigen::Matrix3d error = symmetric / terms.cell.pressure - Eigen::Matrix3d::Identity();
  component("|mean - p_a|/p_a", error.trace() / 3, true);
  component("|P_xx - p_a|/p_a", error(0, 0), shape);
  component("|P_yy - p_a|/p_a", error(1, 1), shape);
  component("|P_zz - p_a|/p_a", error(2, 2), shape);
  component("|P_xy|/p_a", error(0, 1), shears);
  component("|P_xz|/p_a", error(0, 2), shears);
  component("|P_yz|/p_a", error(1, 2), shears);
  component("largest |P_ab - P_ba|/p_a", (p - p.transpose()).cwiseAbs().maxCoeff() / terms.cell.pressure,
            true);
  return part;
}

Part friction_part(const ContactNetwork& network, const Backbone& backbone, const CertificateTerms& terms) {
  const FrictionState state = friction_state(network, backbone);
  Part part;
  part.name = "friction";
  part.asks = "Does every contact stay within its Coulomb cone?";
  part.findings = {told("smallest F_n/mean F_n", state.least_normal)};
  if (!network.frictional()) {
    part.note = "Without friction there is no tangential force to judge.";
    return part;
  }
  part.findings.push_back(
      at_most("largest (|F_t| - mu F_n)/(mu mean F_n)", state.largest_excess, terms.cone_excess));
  part.findings.push_back(
      told("share of the contacts that slide", real(state.sliding) / real(std::ssize(backbone.bonds))));
  return part;
}

Part constraint_part(const ContactNetwork& network, const Backbone& backbone, CellFreedom freedom) {
  const ConstraintCount count = count_constraints(network, backbone, freedom);
  Part part;
  part.name = "constraint count";
  part.asks = "Are there as many constraints as there are ways to move?";
  part.findings = {at_least("constraints of the contacts", real(count.constraints), real(count.needed)),
                   told("excess over the isostatic number", real(count.constraints - count.needed)),
                   told("contacts among the backbone", real(std::ssize(backbone.bonds))),
                   told("coordination of the backbone",
                        2 * real(std::ssize(backbone.bonds)) / real(std::ssize(backbone.particles)))};
  return part;
}

Part stability_part(const Modes& modes, std::size_t shown, std::int64_t sliding) {
  Part part;
  part.name = "stability";
  part.asks = "Does every small motion of the backbone and its cell cost energy?";
  part.findings = {at_least("stiffness factored and eigenvalues converged", modes.valid ? 1 : 0, 1),
                   at_most("motions that cost none, beyond doubt", real(modes.unstable()), 0),
                   at_most("largest |K v - lambda v| [k_n]", modes.residual, 1e-8),
                   told("negative eigenvalues", real(modes.negative))};
  bool sure = modes.valid && sliding == 0;
  std::int64_t open = 0;
  for (std::size_t k = 0; k < modes.lowest.size(); ++k) {
    sure = sure && modes.lowest[k] > modes.doubt[k];
    if (modes.open(k)) ++open;
    if (k >= shown) continue;
    std::string name = "eigenvalue ";
    name += std::to_string(k + 1);
    part.findings.push_back(told(name + " besides translation [k_n]", modes.lowest[k]));
    if (modes.open(k))
      part.findings.push_back(told(name + ", in doubt for want of balance by [k_n]", modes.doubt[k]));
  }
  // A contact that slides has no spring along F_t here, but sticks where a motion unloads it.
  part.proves = sliding > 0 ? Proves::neither : sure ? Proves::sufficient : Proves::necessary;
  if (sliding > 0)
    part.note =
        "Contacts slide. Here they slide in both senses, but a contact that a motion unloads sticks; and F_t "
        "follows F_n, which is no energy. The next part takes both into account.";
  if (open > 0 && sliding > 0) part.note += " ";
  if (open > 0) {
    part.note += std::to_string(open);
    part.note +=
        " of these motions no spring resists, only the turning of forces as weak as the imbalance of their "
        "spheres: whether they are stable cannot be said.";
  }
  return part;
}

/// Text that names the particles with most of the kinetic energy of a motion, and their share of this energy.
std::string movers(const SmallMotion& motion, const Eigen::VectorXcd& z, const Backbone& backbone,
                   const Packing& packing) {
  const Eigen::VectorXd energy = motion.inertia().cwiseProduct(z.cwiseAbs2());
  const Eigen::Index each = motion.per_particle();
  std::vector<std::pair<double, std::int64_t>> shares;
  for (Eigen::Index n = 0; n < motion.particles(); ++n)
    shares.emplace_back(energy.segment(each * n, each).sum() / energy.sum(),
                        packing.id(backbone.particles[static_cast<std::size_t>(n)]));
  std::sort(shares.rbegin(), shares.rend());
  shares.resize(std::min<std::size_t>(shares.size(), 3));
  double share = 0;
  std::string ids;
  for (const auto& [of_one, id] : shares)
    share += of_one, ids += (ids.empty() ? "" : ", ") + std::to_string(id);
  return std::to_string(std::lround(100 * share)) + " % of its energy is in the particles " + ids;
}

/// `in_the_run`: growth with the contacts of the run, given only if these do not feel the cell's flow. If the
/// forces do not balance, the packing still moves; growth is then reported but not judged.
Part growth_part(const SmallMotion& motion, const Growth& growth, const std::optional<Growth>& in_the_run,
                 const Backbone& backbone, Balance balance, const Packing& packing) {
  const bool judged = balance != Balance::off;
  const GrowingMode* both_ways = growth.fastest();
  Part part;
  part.name = "stability with sliding";
  part.asks =
      "Does every small motion die out, with inertia and damping, when F_t of a contact that slides follows "
      "F_n?";
  if (!growth.asked) {
    part.note = "Not asked: too many unknowns to factor.";
    return part;
  }
  const char* const rate_name = "rate of a motion that grows as its contacts go [1/time]";
  const double rate = growth.certain ? growth.certain->rate() : 0;
  part.findings = {at_least("equations of motion solved", growth.valid ? 1 : 0, 1),
                   judged ? at_most(rate_name, rate, 0) : told(rate_name, rate),
                   told("rate of the fastest, were contacts to slide both ways [1/time]",
                        both_ways ? both_ways->rate() : 0)};
  if (both_ways) {
    part.findings.push_back(told("its angular frequency [1/time]", both_ways->lambda.imag()));
    part.findings.push_back(told("its doubt for want of balance [1/time]", both_ways->doubt));
  }
  if (in_the_run) {
    const GrowingMode* own = in_the_run->fastest();
    part.findings.push_back(
        told("rate of the fastest in the run, whose contacts do not feel the cell's flow [1/time]",
             own ? own->rate() : 0));
  }
  const GrowingMode* shown = growth.certain ? &*growth.certain : both_ways;
  if (shown) {
    part.note = !growth.certain ? "Were the contacts that slide to slide both ways, a small motion would grow"
                : judged        ? "The packing is not at a stable rest: a small motion grows"
                                : "A small motion of this state grows";
    part.note += " e-fold in " + std::to_string(std::lround(1 / shown->rate())) + " time units; " +
                 movers(motion, shown->motion, backbone, packing) + ".";
    if (!growth.certain) part.note += " A contact that turns back sticks, and may hold it.";
    if (!judged) part.note += " The forces do not balance yet: what grows here need not grow where they do.";
  }
  return part;
}

Part moduli_part(const Moduli& moduli, CellFreedom freedom) {
  Part part;
  part.name = "moduli";
  part.asks = "Does the packing resist a small compression and small shears?";
  part.findings = {at_least("bulk modulus K [k_n/d_s]", moduli.bulk, flat_mode)};
  const auto shear = [&](const char* name, double value) {
    // If the cell cannot shear, the packing need not resist shear.
    part.findings.push_back(freedom == CellFreedom::triclinic ? at_least(name, value, flat_mode)
                                                              : told(name, value));
  };
  shear("shear modulus G, mean of all directions [k_n/d_s]", moduli.shear);
  shear("least shear modulus of any direction [k_n/d_s]", moduli.least_shear);
  return part;
}

}  // namespace

const char* to_string(Balance balance) {
  switch (balance) {
    case Balance::off:
      return "off";
    case Balance::loose:
      return "loose";
    case Balance::tight:
      return "tight";
  }
  return "";
}

Certificate certify(const Packing& packing, const CertificateTerms& terms) {
  validate(packing);
  const ContactNetwork network = contact_network(packing, terms.springs);
  const CoreRule rule = core_rule(terms.springs);
  const Backbone backbone = find_backbone(network, packing.species, rule);
  const Stiffness stiffness(network, backbone, static_stress(network).trace() / 3);
  const Modes modes = find_modes(stiffness, terms.cell.freedom, terms.eigenvalues);
  const Moduli moduli = moduli_of(modes.relaxed / network.volume);
  // The stability of the packing as a material is computed with contacts that feel the cell's flow. The
  // effect of contacts that do not feel it is no property of the packing.
  CellMotion felt = terms.cell;
  felt.affine_velocity = true;
  const SmallMotion small(network, backbone, felt);
  const Growth growth = find_growth(small);
  std::optional<Growth> in_the_run;
  if (!terms.cell.affine_velocity && terms.cell.freedom != CellFreedom::fixed)
    in_the_run = find_growth(SmallMotion(network, backbone, terms.cell));

  Certificate certificate;
  certificate.particles = std::ssize(packing.radius);
  certificate.backbone = std::ssize(backbone.particles);
  certificate.live_backbone =
      std::ssize(find_backbone(network, packing.species, {.least_contacts = rule.least_contacts}).particles);
  certificate.contacts = std::ssize(backbone.bonds);
  certificate.least_contacts = rule.least_contacts;
  certificate.unlisted = network.unlisted;
  certificate.open = network.open;
  certificate.bulk_modulus = moduli.bulk;
  certificate.shear_modulus = moduli.shear;
  const auto shown = static_cast<std::size_t>(terms.eigenvalues);
  certificate.eigenvalues = modes.lowest;
  if (certificate.eigenvalues.size() > shown) certificate.eigenvalues.resize(shown);
  if (growth.fastest()) certificate.growth_rate = growth.fastest()->rate();
  certificate.kick = Kick(packing.size());
  for (const Eigen::VectorXd& motion : modes.unresisted)
    certificate.kick.add(motion, backbone, packing.radius);
  if (growth.certain) {
    const Eigen::VectorXcd velocity = growth.certain->lambda * growth.certain->motion;
    certificate.kick.add(velocity.real().head(small.per_particle() * small.particles()), backbone,
                         packing.radius);
  }
  certificate.parts = {backbone_part(network, packing.species, backbone),
                       balance_part(network, backbone, terms, certificate.balance),
                       stress_part(network, terms),
                       friction_part(network, backbone, terms),
                       constraint_part(network, backbone, terms.cell.freedom),
                       stability_part(modes, shown, friction_state(network, backbone).sliding),
                       growth_part(small, growth, in_the_run, backbone, certificate.balance, packing),
                       moduli_part(moduli, terms.cell.freedom)};
  return certificate;
}

}  // namespace furnas
