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
    bool replaces = false;                ///< an earlier pack at its place
    std::string valid_from, valid_until;  ///< UTC days; empty: not stated
    std::string secret_key;               ///< of minisign, to sign with; empty: none
};

/// `done` and `total` bytes that were copied; may throw to end the work.
using PackProgress = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// Copies the files into a new folder beside the place, checks it as a start does, and renames it to its place; an earlier pack
/// and the new one change places in one step, and the earlier one is then removed; it must be one whose manifest lists all that
/// lies in it. After an error nothing has changed. A power cut may leave the folder beside (`<folder>.part.XXXXXX`), which may be
/// removed. Returns what the check found; its seal is that of the folder beside, so it is not for confirm_pack(). Throws
/// UserError.
platform::CheckedPack write_pack(const PackContents& contents, const PackSettings& settings, const PackProgress& progress);

}  // namespace tedavis::host_sim
