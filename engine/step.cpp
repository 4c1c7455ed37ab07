#include "engine/step.h"

#include "engine/phases/barostat.h"
#include "engine/phases/forces.h"
#include "engine/phases/integrate.h"
#include "engine/phases/keep_ledger.h"

namespace furnas {

// clang-format off
template <class S>
StepGraph make_step(const Model& model, const std::size_t& particles, State<S>& s, StepWork& w) {
  StepGraph step;
  const double& dt = model.time_step;
  const Barostat& bath = model.barostat;
  const bool moves = bath.freedom != CellFreedom::fixed;

  if (moves) step.phase("kick the cell",    kick_cell,            bath, dt, particles, s.stress, s.cell);
  if (moves) step.phase("book the drag",    book_cell_drag,       dt, particles, s.cell, s.stress.motion, s.ledger);
  if (moves) step.phase("stretch the cell", stretch_cell,         bath, dt, s.cell);
  step.phase("kick and drift",              kick_and_drift<S>,    bath, dt, s.cell, s.pairs, s.memory, s.loads, s.particles, w.longest_way);
  if (moves) step.phase("stretch the cell", stretch_cell,         bath, dt, s.cell);

  step.phase("watch the wear",              watch_wear,           s.step, w.longest_way, s.cell, s.pairs, w.wear);
  step.phase_when(w.wear.suspect, "measure the wear", measure_wear<S>, model.skin, s.step, s.cell, s.pairs, s.particles, w.wear);
  step.phase_when(w.wear.worn, "bin the particles",   bin_particles<S>, model.skin, s.step, s.cell, w.wear, s.pairs, s.particles, w.draft);
  step.phase_when(w.wear.worn, "search the pairs",    search_pairs,    s.cell, w.draft);
  step.phase_when(w.wear.worn, "adopt the list",      adopt_list<S>,   s.step, w.draft, s.pairs, s.rows, s.memory, s.image, w.wear);

  step.phase("watch the near rows",         watch_near_rows,      s.step, dt, w.longest_way, s.cell, s.pairs, w.near);
  step.phase("contact forces",              contact_forces<S>,    model, dt, s.cell, s.pairs, s.particles, s.loads, s.rows, s.memory, w.near, s.stress.contacts, w.work);
  step.phase("book the contacts",           book_contacts,        dt, s.cell, w.work, s.ledger);
  step.phase("gather and kick",             gather_and_kick<S>,   bath, dt, s.cell, s.pairs, s.rows, s.memory, s.loads, s.particles, s.stress.motion);
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
  step.name(s.memory, "memory of contacts");
  step.name(s.image, "image");
  step.name(w.longest_way, "longest way");
  step.name(w.wear, "wear");
  step.name(w.near, "near rows");
  step.name(w.draft, "draft of the list");
  return step;
}

#define FURNAS_INSTANTIATE(Law, Real)                                                                        \
  template StepGraph make_step<Scene<Law, Real>>(const Model&, const std::size_t&, State<Scene<Law, Real>>&, \
                                                 StepWork&);
FURNAS_FOR_EACH_SCENE(FURNAS_INSTANTIATE)
#undef FURNAS_INSTANTIATE

}  // namespace furnas
