/// Signs files with minisign(1), run as a program.
#pragma once

#include <string>

namespace tedavis::host_sim {

/// Writes `<file>.minisig`. minisign asks on the terminal for the key's password, if the key has one. Throws UserError where
/// minisign is not installed or does not sign, and Interrupted where Ctrl-C ends it.
void sign_with_minisign(const std::string& file, const std::string& secret_key);

}  // namespace tedavis::host_sim
