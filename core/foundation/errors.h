// What may go wrong, as types.
#pragma once

#include <stdexcept>
#include <string>

namespace orogen {

/// Input that cannot be used. The message names the field, the place and the allowed range.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The work was stopped on request; nothing was changed.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

}  // namespace orogen
