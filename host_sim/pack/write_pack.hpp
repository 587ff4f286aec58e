/// Writes a pack (platform/configuration/pack_check.hpp): whole or not at all, also when power fails.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "host_sim/pack/pack_contents.hpp"
#include "platform/configuration/pack_check.hpp"

namespace tedavis::host_sim {

struct PackSettings {
    std::string folder;                   ///< to write
    bool replaces = false;                ///< an earlier pack at `folder` may be replaced
    std::string valid_from, valid_until;  ///< UTC days as "2026-12-28"; empty: not stated
    std::string secret_key;               ///< file of a minisign key to sign with; empty: not signed
};

/// Called with the bytes copied so far and in all; may throw to end the work.
using PackProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Copies the files into a temporary folder beside `folder`, checks it as the board does at its start, and renames it. An earlier
/// pack is exchanged with the new one in one step and then removed; its manifest must list every file in it. After an error
/// nothing has changed. A power failure may leave the temporary folder (`<folder>.part.XXXXXX`), which may be removed. Returns
/// the result of the check; its seal belongs to the temporary folder, so it must not be given to confirm_pack(). Throws
/// UserError.
platform::CheckedPack write_pack(const PackContents& contents, const PackSettings& settings, const PackProgress& progress);

}  // namespace tedavis::host_sim
