#include "engine/graph/step_graph.h"

#include <tbb/flow_graph.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <numeric>
#include <ostream>

#include "engine/base/parallel.h"
#include "engine/base/team.h"

namespace furnas {

/// The flow graph determines when a phase is due; the threads of the Workers run it. Tasks of oneTBB cannot
/// be used for this, because all threads of oneTBB already poll for loops inside the phases
/// (engine/base/team.h).
struct StepGraph::Flow {
  using Message = tbb::flow::continue_msg;

  struct Turn : Job {
    Turn(Flow& its_flow, const Phase& its_phase)
        : Job{take}, flow(its_flow), phase(its_phase), come(flow.graph, [this](Message) {
            ++flow.open;
            due.push(*this);
            return Message{};
          }) {}
    static void take(Job& job) {
      auto& turn = static_cast<Turn&>(job);
      turn.flow.run_from(&turn);
    }

    Flow& flow;
    const Phase& phase;
    tbb::flow::continue_node<Message, tbb::flow::lightweight> come;  ///< waits for all phases that it needs
    tbb::flow::broadcast_node<Message> done{flow.graph};
  };

  explicit Flow(const std::vector<Phase>& phases);
  void run();
  void run_from(Job* turn);
  static Job* share_out();

  /// Phases that became due by the last work of this thread.
  static thread_local JobQueue due;

  tbb::flow::graph graph;
  std::vector<std::unique_ptr<Turn>> turns;
  std::vector<Turn*> roots;
  std::atomic<std::size_t> open{0};  ///< phases that are due and not yet done
  std::atomic<bool> failed{false};
  std::exception_ptr failure;  ///< of the first phase that failed
};

thread_local JobQueue StepGraph::Flow::due;

StepGraph::Flow::Flow(const std::vector<Phase>& phases) {
  for (const Phase& phase : phases) turns.push_back(std::make_unique<Turn>(*this, phase));
  // Length of the longest chain of phases that must follow each phase. Of the phases that become due
  // together, the one with the longest chain comes first; the present thread continues with this phase.
  std::vector<std::size_t> follow(phases.size(), 0);
  for (std::size_t k = phases.size(); k-- > 0;)
    for (std::size_t before : phases[k].waits_for) follow[before] = std::max(follow[before], follow[k] + 1);
  std::vector<std::size_t> order(phases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return follow[a] > follow[b]; });
  for (std::size_t k : order) {
    for (std::size_t before : phases[k].waits_for) tbb::flow::make_edge(turns[before]->done, turns[k]->come);
    if (phases[k].waits_for.empty()) roots.push_back(turns[k].get());
  }
}

void StepGraph::Flow::run() {
  for (Turn* root : roots) root->come.try_put(Message{});
  if (Job* first = share_out()) run_from(first);
  detail::help_until_none(open);
  if (failure) std::rethrow_exception(failure);
}

/// Returns the first due phase, with which this thread continues, and offers the other due phases to the
/// other threads.
Job* StepGraph::Flow::share_out() {
  Job* const mine = due.pop();
  while (Job* other = due.pop()) detail::offer(*other);
  return mine;
}

/// Runs a phase, then one that has become due by it, and so on.
void StepGraph::Flow::run_from(Job* job) {
  while (job != nullptr) {
    auto& turn = static_cast<Turn&>(*job);
    try {
      if (!failed) StepGraph::run(turn.phase);
    } catch (...) {
      if (!failed.exchange(true)) failure = std::current_exception();
    }
    if (!failed) turn.done.try_put(Message{});
    job = share_out();
    --open;  // last access of this thread to the step if no phase is left for it
  }
}

StepGraph::StepGraph() = default;
StepGraph::~StepGraph() = default;
StepGraph::StepGraph(StepGraph&&) noexcept = default;
StepGraph& StepGraph::operator=(StepGraph&&) noexcept = default;

bool StepGraph::overlap(const Range& a, const Range& b) {
  const std::less<> before;  // a total order even for pointers into different objects
  return before(a.begin, b.begin + b.size) && before(b.begin, a.begin + a.size);
}

bool StepGraph::conflict(const Phase& earlier, const Phase& later) {
  for (const Access& a : earlier.accesses)
    for (const Access& b : later.accesses)
      if ((a.writes || b.writes) && overlap(a.range, b.range)) return true;
  return false;
}

void StepGraph::add(std::string title, const bool* flag, std::vector<Access> accesses,
                    std::function<void()> run) {
  Phase phase{std::move(title), flag, std::move(accesses), std::move(run), {}, nullptr};
  // Edges that follow from other edges are left out. The loop begins with the nearest earlier phase; the
  // phases for which a conflicting phase already waits are covered and need no edge.
  std::vector<bool> covered(phases_.size(), false);
  for (std::size_t k = phases_.size(); k-- > 0;) {
    if (covered[k]) {
      for (std::size_t before : phases_[k].waits_for) covered[before] = true;
    } else if (conflict(phases_[k], phase)) {
      phase.waits_for.insert(phase.waits_for.begin(), k);
      for (std::size_t before : phases_[k].waits_for) covered[before] = true;
    }
  }
  phases_.push_back(std::move(phase));
  flow_.reset();
}

void StepGraph::run(const Phase& phase) {
  if (phase.flag && !*phase.flag) return;
  if (!phase.time) return phase.run();
  const auto begin = std::chrono::steady_clock::now();
  phase.run();
  phase.time->seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++phase.time->runs;
}

void StepGraph::run_in_order() {
  for (const Phase& phase : phases_) run(phase);
}

void StepGraph::run_as_graph() {
  if (!detail::at_work()) return run_in_order();
  if (!flow_) flow_ = std::make_unique<Flow>(phases_);
  try {
    flow_->run();
  } catch (...) {
    flow_.reset();  // nodes may hold half-counted messages
    throw;
  }
}

void StepGraph::keep_times(std::vector<PhaseTime>* times) const {
  if (times) times->assign(phases_.size(), {});
  for (std::size_t k = 0; k < phases_.size(); ++k) phases_[k].time = times ? &(*times)[k] : nullptr;
}

std::vector<std::string> StepGraph::titles() const {
  std::vector<std::string> titles;
  for (const Phase& phase : phases_) titles.push_back(phase.title);
  return titles;
}

std::string StepGraph::name_of(const Range& range) const {
  for (const Name& name : names_)
    if (name.range.begin == range.begin && name.range.size == range.size) return name.text;
  return {};
}

void StepGraph::write_dot(std::ostream& out) const {
  out << "digraph step {\n  rankdir=TB;\n  node [shape=box, fontname=\"Helvetica\", style=rounded];\n";
  for (std::size_t k = 0; k < phases_.size(); ++k) {
    std::string reads;
    std::string writes;
    for (const Access& access : phases_[k].accesses) {
      const std::string name = name_of(access.range);
      std::string& list = access.writes ? writes : reads;
      if (!name.empty()) list += (list.empty() ? "" : ", ") + name;
    }
    out << "  p" << k << " [label=<<b>" << phases_[k].title << "</b>";
    if (!reads.empty()) out << "<br/><font point-size=\"10\">reads " << reads << "</font>";
    if (!writes.empty()) out << "<br/><font point-size=\"10\">writes " << writes << "</font>";
    out << ">" << (phases_[k].flag ? ", style=\"rounded,dashed\"" : "") << "];\n";
  }
  for (std::size_t k = 0; k < phases_.size(); ++k)
    for (std::size_t before : phases_[k].waits_for) out << "  p" << before << " -> p" << k << ";\n";
  out << "}\n";
}

}  // namespace furnas
