#pragma once

namespace furnas {

/// The exit codes of the program.
enum class ExitCode {
  done = 0,               ///< jammed or settled, or the command did what it was asked
  internal_error = 1,     ///< an error in the program
  bad_case = 2,           ///< the case file, an option or a path cannot be used
  refused = 3,            ///< the preflight found that the case would fail
  not_certified = 4,      ///< a part of the certificate failed
  budget_spent = 5,       ///< steps or wall time ran out; the run can be resumed
  numerical_failure = 6,  ///< the packing diverged; the last sound state is saved
  output_failed = 7,      ///< a file could not be written; the last checkpoint is good
  folder_in_use = 8,      ///< another run works in the folder
  out_of_memory = 9,      ///< the last checkpoint is good
  samples_failed = 10,    ///< of a sweep, some or all samples failed
  samples_left = 11,      ///< the wall time of a sweep is spent, and samples are left
  interrupted = 130,      ///< a signal stopped the run after a checkpoint
};

}  // namespace furnas
