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

/// What a phase has taken so far.
struct PhaseTime {
  double seconds{};     ///< wall time
  std::int64_t runs{};  ///< times that it ran
};

/// The phases of a timestep in order, and the oneTBB flow graph that follows from what they touch.
///
/// A phase is a free function: a `const T&` parameter is read, a `T&` parameter is written. A phase
/// waits for an earlier one exactly when both touch the same object and one of them writes it. So the
/// order of the lines is the meaning, and the graph is permission to overlap.
class StepGraph {
 public:
  StepGraph();
  ~StepGraph();
  StepGraph(StepGraph&&) noexcept;
  StepGraph& operator=(StepGraph&&) noexcept;

  /// Gives an object the name that the drawing shows.
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

  /// Adds a phase that runs only in steps in which `flag` is set when its turn comes.
  template <class... Parameters, class... Arguments>
  void phase_when(const bool& flag, const std::string& title, void (*function)(Parameters...),
                  Arguments&... arguments) {
    add(title, &flag, {access<Parameters>(arguments)..., Access{range_of(flag), false}},
        [function, &arguments...] { function(arguments...); });
  }

  /// One step, phase after phase: the reference, and what small systems use.
  void run_in_order();

  /// One step as a flow graph: inside Workers::run phases that do not wait for each other run at once, as far
  /// as there are threads; elsewhere they run in order. What a phase throws reaches the caller once no phase
  /// runs any more; those that had not begun are left out.
  void run_as_graph();

  /// From now on keeps the time of each phase in `times`, one entry a phase in order, from zero; with nothing
  /// it keeps none, as at first. Time is no part of the step: a graph that may only be looked at can be
  /// timed.
  void keep_times(std::vector<PhaseTime>* times) const;

  /// The drawing of the step in the language of Graphviz.
  void write_dot(std::ostream& out) const;

  /// Titles of the phases in order.
  std::vector<std::string> titles() const;

  /// The phases that phase `index` waits for, without those that follow from others.
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
    mutable PhaseTime* time;  ///< where its time is kept, if it is
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
