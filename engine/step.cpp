#include "engine/step.h"

#include "engine/phases/barostat.h"
#include "engine/phases/forces.h"
#include "engine/phases/integrate.h"
#include "engine/phases/keep_ledger.h"

namespace furnas {

// clang-format off
template <class S>
StepGraph make_step(const Model& model, const std::size_t& particles, State<S>& s, StepWork<typename S::Real>& w) {
  using Real = typename S::Real;
  StepGraph step;
  const double& dt = model.time_step;
  const Barostat& bath = model.barostat;
  const bool moves = bath.freedom != CellFreedom::fixed;

  if (moves) step.phase("kick the cell",    kick_cell,            bath, dt, particles, s.stress, s.cell);
  if (moves) step.phase("book the drag",    book_cell_drag,       dt, particles, s.cell, s.stress.motion, s.ledger);
  if (moves) step.phase("stretch the cell", stretch_cell,         bath, dt, s.cell);
  step.phase("kick and drift",              kick_and_drift<S>,    bath, dt, s.cell, s.pairs, s.contact_state, s.loads, s.particles, w.squared_displacement);
  if (moves) step.phase("stretch the cell", stretch_cell,         bath, dt, s.cell);

  step.phase("add the displacement",              add_displacement,           s.step, w.squared_displacement, s.cell, s.pairs, w.displacement);
  step.phase_when(w.displacement.suspect, "measure the displacement", measure_displacement<S>, model.skin, s.step, s.cell, s.pairs, s.particles, w.displacement);
  step.phase_when(w.displacement.outdated, "bin the particles",   bin_particles<S>, model.skin, s.step, s.cell, w.displacement, s.particles, s.pairs, s.image, w.draft);
  step.phase_when(w.displacement.outdated, "pick up the contacts", pick_up_contacts<Real>, s.pairs, s.contact_state, w.draft);
  step.phase_when(w.displacement.outdated, "search the pairs",    search_pairs<Real>, s.step, s.cell, w.draft, s.pairs);
  step.phase_when(w.displacement.outdated, "put down the contacts", put_down_contacts<S>, s.pairs, w.draft, s.rows, s.contact_state, w.displacement);

  step.phase("watch the inner list",         watch_inner_list,      s.step, dt, w.squared_displacement, s.cell, s.pairs, w.inner);
  step.phase("contact forces",              contact_forces<S>,    model, dt, s.cell, s.pairs, s.particles, s.loads, s.rows, s.contact_state, w.inner, s.stress.contacts, w.work);
  step.phase("book the contacts",           book_contacts,        dt, s.cell, w.work, s.ledger);
  step.phase("gather and kick",             gather_and_kick<S>,   bath, dt, s.cell, s.pairs, s.rows, s.contact_state, s.loads, s.particles, s.stress.motion);
  if (moves) step.phase("book the drag",    book_cell_drag,       dt, particles, s.cell, s.stress.motion, s.ledger);
  if (moves) step.phase("kick the cell",    kick_cell,            bath, dt, particles, s.stress, s.cell);
  // clang-format on

  step.name(s.cell, "cell");
  step.name(s.stress, "stress");
  step.name(s.stress.contacts, "stress of contacts");
  step.name(s.stress.motion, "stress of motion");
  step.name(s.ledger, "ledger");
  step.name(w.work, "work of contacts");
  step.name(s.particles, "particles");
  step.name(s.loads, "loads");
  step.name(s.pairs, "pairs");
  step.name(s.rows, "rows");
  step.name(s.contact_state, "contact state");
  step.name(s.image, "image");
  step.name(w.squared_displacement, "displacement in the step");
  step.name(w.displacement, "displacement");
  step.name(w.inner, "inner list");
  step.name(w.draft, "draft of the list");
  return step;
}

#define FURNAS_INSTANTIATE(Law, Real)                                                 \
  template StepGraph make_step<Numerics<Law, Real>>(const Model&, const std::size_t&, \
                                                    State<Numerics<Law, Real>>&, StepWork<Real>&);
FURNAS_FOR_EACH_NUMERICS(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
