#pragma once

#include <boost/process/child.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace furnas {

/// The program itself in a process of its own, which a signal to the terminal does not reach; it is asked to
/// save and stop when its parent dies.
class Child {
 public:
  /// Starts `furnas ARGUMENTS`; what it prints goes to the file `log`.
  Child(const std::vector<std::string>& arguments, const std::filesystem::path& log);
  Child(Child&&) = default;
  Child& operator=(Child&&) = default;

  /// The exit code once it has ended; of one that a signal ended, minus the signal.
  std::optional<int> ended();

  /// Asks it to save and stop.
  void stop();

  /// Ends it at once, unsaved, and waits for that.
  void kill();

 private:
  boost::process::child process_;
};

}  // namespace furnas
