/// Whether a seat manager (seatd, or logind for the session on a console) may open the graphics card for this program. Without
/// one the program opens the card itself.
///
/// Thread  one. Memory  none. Failure  what cannot be found out counts as absent.
#pragma once

#include "render_core/base/fixed_string.hpp"

namespace tedavis::platform {

/// What libseat would go by.
struct SeatSigns {
    const char* backend = nullptr;  ///< LIBSEAT_BACKEND: the backend that the user asks for; null: not set
    const char* session = nullptr;  ///< XDG_SEAT: set by logind in a session that has a screen; null: none
    const char* socket = nullptr;   ///< of seatd
    bool is_root = false;
};

struct SeatOffer {
    bool is_there = false;
    /// What it is, or what keeps the program from it; empty where there is nothing to say.
    base::FixedString<255> text;
};

[[nodiscard]] SeatSigns machine_seat_signs();

/// Asks no manager for a seat; connects to seatd for a moment. Root gets a seat only from a backend that it names: where no
/// manager gives one, libseat goes on to its builtin backend, which for root takes over the terminal that is shown.
[[nodiscard]] SeatOffer find_seat(const SeatSigns& signs = machine_seat_signs());

/// False where libseat was missing at the build.
[[nodiscard]] bool can_use_seats();

}  // namespace tedavis::platform
