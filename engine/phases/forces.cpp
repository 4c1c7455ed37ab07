#include "engine/phases/forces.h"

#include <cmath>

#include "engine/base/parallel.h"

namespace furnas {
namespace {

// Pieces of particles, not of rows, so that the order of the sums does not depend on the skin.
constexpr std::size_t chunk = 256;

/// Sum of branch (x) force.
struct Virial {
  Vec3<double> x, y, z;  ///< rows: the force weighted with one component of the branch
  void add(const Vec3<double>& branch, const Vec3<double>& force) {
    x += branch.x * force;
    y += branch.y * force;
    z += branch.z * force;
  }
  void operator+=(const Virial& b) { x += b.x, y += b.y, z += b.z; }
};

/// What a piece of particles adds up.
struct Sum {
  Virial virial;
  ContactWork work;
  void operator+=(const Sum& b) { virial += b.virial, work += b.work; }
};

/// The law with what it needs to see two particles as a touch.
template <class Scene>
class Encounter {
 public:
  using Real = typename Scene::Real;
  using Body = Particle<Real, Scene::spins>;
  using LoadOf = Load<Real, Scene::spins>;
  using Answer = Row<Real, Scene::spins>;

  Encounter(const Model& model, double time_step, const Cell& cell)
      : law_(std::get<typename Scene::Law>(model.law)),
        cell_(cell),
        time_step_(time_step),
        affine_(model.affine_velocity) {}

  /// Branch of two particles whose fractional coordinates differ by `difference` [d_s].
  Vec3<double> branch(const Vec3<double>& difference) const { return cell_.edges * difference; }

  /// Row of a pair whose squared distance is below the square of the sum of the radii.
  Answer operator()(const Body& i, const LoadOf& load_i, const Body& j, const LoadOf& load_j,
                    const Vec3<double>& branch, Vec3<Real>& history, ContactWork& work) const {
    Touch<Real> touch;
    touch.branch = {Real(branch.x), Real(branch.y), Real(branch.z)};
    touch.distance = norm(touch.branch);
    touch.overlap = i.radius + j.radius - touch.distance;
    touch.radius_i = i.radius;
    touch.radius_j = j.radius;
    touch.reduced_mass = Real(1) / (i.inverse_mass + j.inverse_mass);
    touch.time_step = Real(time_step_);
    touch.midway.velocity = i.velocity - j.velocity;
    const Vec3<double> flow = cell_.rate * branch;
    touch.drift = touch.midway.velocity + flow;
    if (affine_) touch.midway.velocity = touch.drift;
    if constexpr (Scene::spins) {
      touch.midway.spin_i = i.spin;
      touch.midway.spin_j = j.spin;
    }
    if constexpr (Scene::Law::synchronized) predict(i, load_i, j, load_j, touch);

    const Reaction<Real> reaction = law_(touch, history);
    const Vec3<Real> normal = touch.branch * (Real(1) / touch.distance);
    book(reaction, normal, branch, work);
    if constexpr (Scene::spins)
      return {reaction.force, cross(normal, reaction.force), reaction.shortening};
    else
      return {reaction.force};
  }

  /// A contact that opens leaves the energy of its tangential spring behind; over half of the step the spring
  /// has still worked.
  void open(const Body& i, const Body& j, const Vec3<double>& branch, Vec3<Real>& history,
            ContactWork& work) const {
    if (history == Vec3<Real>{}) return;
    const Vec3<double> normal = branch * (1 / norm(branch));
    RelativeMotion<Real> motion{i.velocity - j.velocity, i.spin, j.spin};
    if (affine_) motion.velocity += cell_.rate * branch;
    const Vec3<Real> slip =
        slip_velocity(motion, {Real(normal.x), Real(normal.y), Real(normal.z)}, i.radius, j.radius);
    work.losses.opening += tangential_energy(law_.constants, history) +
                           0.5 * time_step_ * law_.constants.tangential_stiffness * dot(history, slip);
    history = {};
  }

 private:
  /// The flow of the cell works against damping and friction only if they see it.
  void book(const Reaction<Real>& r, const Vec3<Real>& normal, const Vec3<double>& branch,
            ContactWork& work) const {
    const Vec3<Real> f = affine_ ? r.force : r.normal_spring * normal;
    work.add({f.x, f.y, f.z}, branch);
    work.losses.normal_damping += r.losses.normal_damping;
    work.losses.tangential_damping += r.losses.tangential_damping;
    work.losses.sliding += r.losses.sliding;
  }

  /// The motion at the end of the step, with the forces of its start: second order in the step.
  void predict(const Body& i, const LoadOf& load_i, const Body& j, const LoadOf& load_j,
               Touch<Real>& touch) const {
    const Real half = Real(0.5 * time_step_);
    touch.now.velocity =
        touch.midway.velocity + half * (i.inverse_mass * load_i.force - j.inverse_mass * load_j.force);
    if constexpr (Scene::spins) {
      touch.now.spin_i = i.spin + (half * i.inverse_inertia) * load_i.torque;
      touch.now.spin_j = j.spin + (half * j.inverse_inertia) * load_j.torque;
    }
  }

  const typename Scene::Law& law_;
  const Cell& cell_;
  double time_step_;
  bool affine_;
};

}  // namespace

template <class Scene>
void contact_forces(const Model& model, const double& time_step, const Cell& cell, const PairList& pairs,
                    const std::vector<Particle<typename Scene::Real, Scene::spins>>& particles,
                    const std::vector<Load<typename Scene::Real, Scene::spins>>& loads,
                    std::vector<Row<typename Scene::Real, Scene::spins>>& rows,
                    std::vector<Vec3<typename Scene::Real>>& history, Eigen::Matrix3d& stress,
                    ContactWork& work) {
  const Encounter<Scene> encounter(model, time_step, cell);
  const bool nearest = pairs.quarter.empty();
  Vec3<typename Scene::Real> no_history;

  const auto piece = [&](std::size_t begin, std::size_t end) {
    Sum sum;
    for (std::size_t i = begin; i < end; ++i) {
      const auto& p = particles[i];
      for (std::uint64_t k = pairs.first[i]; k < pairs.first[i + 1]; ++k) {
        const std::uint32_t j = pairs.partner[k];
        const auto& q = particles[j];
        Vec3<double> branch =
            encounter.branch(nearest ? nearest_difference(p.position, q.position)
                                     : row_difference(p.position, q.position, pairs.quarter[k]));
        const double reach = static_cast<double>(p.radius) + static_cast<double>(q.radius);
        const double square = dot(branch, branch);
        if (square >= reach * reach) {
          rows[k] = {};
          if constexpr (Scene::spins) encounter.open(p, q, branch, history[k], sum.work);
          continue;
        }
        // Centres that coincide have no normal; they part along x.
        if (square == 0) branch = {1e-9 * reach, 0, 0};
        auto& memory = [&]() -> auto& {
          if constexpr (Scene::spins)
            return history[k];
          else
            return no_history;
        }
        ();
        rows[k] = encounter(p, loads[i], q, loads[j], branch, memory, sum.work);
        const auto& f = rows[k].force;
        sum.virial.add(branch, {f.x, f.y, f.z});
      }
    }
    return sum;
  };
  const Sum sum = ordered_sum<Sum>(particles.size(), chunk, piece);
  const Virial& v = sum.virial;
  stress << v.x.x, v.x.y, v.x.z, v.y.x, v.y.y, v.y.z, v.z.x, v.z.y, v.z.z;
  work = sum.work;
}

#define FURNAS_INSTANTIATE(Law)                                                                       \
  template void contact_forces<Scene<Law, double>>(                                                   \
      const Model&, const double&, const Cell&, const PairList&,                                      \
      const std::vector<Particle<double, Law::spins>>&, const std::vector<Load<double, Law::spins>>&, \
      std::vector<Row<double, Law::spins>>&, std::vector<Vec3<double>>&, Eigen::Matrix3d&, ContactWork&);
FURNAS_FOR_EACH_LAW(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
