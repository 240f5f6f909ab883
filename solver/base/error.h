// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace hydroscope {

/// Bad input from the user: the message names file, line, key, value and what
/// was expected. The program ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The surroundings fail (renderer missing, disk full, folder not writable).
/// The program ends with exit code 5.
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A broken contract inside the program; never the user's fault.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws ContractError when `holds` is false; stays on in release builds.
inline void require(bool holds, const char* what) {
  if (!holds) throw ContractError(what);
}

}  // namespace hydroscope
