#include "engine/graph/step_graph.h"

#include <tbb/flow_graph.h>

#include <algorithm>
#include <chrono>
#include <ostream>

namespace furnas {

struct StepGraph::Flow {
  using Node = tbb::flow::continue_node<tbb::flow::continue_msg>;
  tbb::flow::graph graph;
  std::vector<std::unique_ptr<Node>> nodes;
  std::vector<Node*> roots;
};

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
  // An edge that follows from others is left out: the nearest conflicts come first, and what they wait
  // for is covered.
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
  if (!flow_) {
    flow_ = std::make_unique<Flow>();
    for (const Phase& phase : phases_) {
      flow_->nodes.push_back(std::make_unique<Flow::Node>(
          flow_->graph, [&phase](const tbb::flow::continue_msg&) { run(phase); }));
      for (std::size_t before : phase.waits_for)
        tbb::flow::make_edge(*flow_->nodes[before], *flow_->nodes.back());
      if (phase.waits_for.empty()) flow_->roots.push_back(flow_->nodes.back().get());
    }
  }
  try {
    for (Flow::Node* root : flow_->roots) root->try_put(tbb::flow::continue_msg{});
    flow_->graph.wait_for_all();
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
