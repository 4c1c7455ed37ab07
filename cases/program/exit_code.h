#pragma once

namespace furnas {

/// What the program tells the shell when it ends.
enum class ExitCode {
  done = 0,               ///< jammed, or the command did what it was asked
  internal_error = 1,     ///< a mistake of the program
  bad_case = 2,           ///< the case file, an option or a path cannot be used
  refused = 3,            ///< the preflight found that the case would fail
  not_certified = 4,      ///< a part of the certificate failed
  budget_spent = 5,       ///< steps or wall time ran out; the run can be resumed
  numerical_failure = 6,  ///< the packing diverged; the last good state is saved
  output_failed = 7,      ///< a file could not be written; the last checkpoint is good
  folder_in_use = 8,      ///< another run works in the folder
  out_of_memory = 9,      ///< the last checkpoint is good
  samples_failed = 10,    ///< of a sweep, some or all
  samples_left = 11,      ///< of a sweep whose wall time is spent
  interrupted = 130,      ///< a signal stopped the run after a checkpoint
};

}  // namespace furnas
