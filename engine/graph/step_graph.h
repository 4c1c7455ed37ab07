#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace furnas {

/// The time that a phase has taken so far.
struct PhaseTime {
  double seconds{};     ///< wall time
  std::int64_t runs{};  ///< number of runs
};

/// The phases of a timestep in order, and the oneTBB flow graph that follows from what the phases read and
/// write.
///
/// A phase is a free function: a `const T&` parameter is read, a `T&` parameter is written. A phase waits for
/// an earlier one exactly when both use the same object and at least one of them writes it. The result is
/// that of the phases in their order; the graph only allows independent phases to run at the same time.
class StepGraph {
 public:
  StepGraph();
  ~StepGraph();
  StepGraph(StepGraph&&) noexcept;
  StepGraph& operator=(StepGraph&&) noexcept;

  /// Gives an object the name that is shown in the drawing (write_dot).
  template <class T>
  void name(const T& object, std::string text) {
    names_.push_back({range_of(object), std::move(text)});
  }

  /// Adds a phase that calls function(arguments...) each step.
  template <class... Parameters, class... Arguments>
  void phase(const std::string& title, void (*function)(Parameters...), Arguments&... arguments) {
    add(title, nullptr, {access<Parameters>(arguments)...},
        [function, &arguments...] { function(arguments...); });
  }

  /// Adds a phase that runs only if `flag` is set when the phase is due.
  template <class... Parameters, class... Arguments>
  void phase_when(const bool& flag, const std::string& title, void (*function)(Parameters...),
                  Arguments&... arguments) {
    add(title, &flag, {access<Parameters>(arguments)..., Access{range_of(flag), false}},
        [function, &arguments...] { function(arguments...); });
  }

  /// One step, phase after phase: the reference, also used for small systems.
  void run_in_order();

  /// One step as a flow graph. Inside Workers::run phases that do not wait for each other run at the same
  /// time, as far as there are threads; elsewhere the phases run in order. If a phase throws, phases that
  /// have not begun are skipped, and the exception reaches the caller when no phase runs any more.
  void run_as_graph();

  /// From now on adds up the time of each phase in `times`, starting from zero, with one entry per phase in
  /// order. With a null pointer times are no longer measured; this is also the initial state. The function is
  /// const because times are no part of the step.
  void keep_times(std::vector<PhaseTime>* times) const;

  /// The drawing of the step in the language of Graphviz.
  void write_dot(std::ostream& out) const;

  /// Titles of the phases in order.
  std::vector<std::string> titles() const;

  /// The phases that phase `index` waits for, without those that it waits for indirectly.
  const std::vector<std::size_t>& waits_for(std::size_t index) const { return phases_[index].waits_for; }

 private:
  struct Range {
    const char* begin;
    std::size_t size;
  };
  struct Access {
    Range range;
    bool writes;
  };
  struct Phase {
    std::string title;
    const bool* flag;
    std::vector<Access> accesses;
    std::function<void()> run;
    std::vector<std::size_t> waits_for;
    mutable PhaseTime* time;  ///< where its time is added up; null: nowhere
  };
  struct Name {
    Range range;
    std::string text;
  };
  struct Flow;

  template <class T>
  static Range range_of(const T& object) {
    return {reinterpret_cast<const char*>(&object), sizeof(T)};
  }

  template <class Parameter, class T>
  static Access access(T& object) {
    constexpr bool writes =
        std::is_lvalue_reference_v<Parameter> && !std::is_const_v<std::remove_reference_t<Parameter>>;
    return {range_of(object), writes};
  }

  static bool overlap(const Range& a, const Range& b);
  static bool conflict(const Phase& earlier, const Phase& later);
  static void run(const Phase& phase);
  void add(std::string title, const bool* flag, std::vector<Access> accesses, std::function<void()> run);
  std::string name_of(const Range& range) const;

  std::vector<Phase> phases_;
  std::vector<Name> names_;
  std::unique_ptr<Flow> flow_;
};

}  // namespace furnas
