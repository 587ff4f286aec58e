/// Signatures of minisign(1): Ed25519 over the BLAKE2b-512 hash of a file, and over the trusted comment.
///
/// Failure  one sentence that names the file.
#pragma once

#include <string_view>

#include "render_core/base/error.hpp"

namespace tedavis::platform {

/// Checks that `content`, read from `file`, was signed with the key whose public half is the file `public_key`; the signature
/// lies beside the file as `<file>.minisig`. Signatures of the older kind, over the file itself, are refused.
[[nodiscard]] base::Error verify_minisign(std::string_view content, std::string_view file, const char* public_key);

}  // namespace tedavis::platform
