#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "io/case.h"
#include "io/output_field.h"
#include "io/result.h"

namespace furnas {

/// A number or word of result.json. The table of all is the only place that knows their names; writing and
/// documenting go through it.
struct ResultField {
  OutputField about;  ///< "stress.xx" is the field "xx" of an object "stress"
  /// NaN and infinity become null in the file.
  nlohmann::ordered_json (*value)(const Result&, const Case&);
};

/// The same for an entry of "rattlers", one for each threshold of contacts.
struct RattlerField {
  OutputField about;
  nlohmann::ordered_json (*value)(const RattlerCount&, const Result&);
};

/// The same for an entry of "resting_states", one for each pressure at which the packing came to rest or
/// settled.
struct RestingField {
  OutputField about;
  nlohmann::ordered_json (*value)(const RestingState&, const Result&);
};

/// All fields, in the order of the file; "rattlers" and "resting_states" are lists with fields of their own.
std::span<const ResultField> result_fields();
/// The fields of an element of "rattlers".
std::span<const RattlerField> rattler_fields();
/// The fields of an element of "resting_states".
std::span<const RestingField> resting_fields();

}  // namespace furnas
