/// The content of a small file in memory, for configuration at start.
///
/// Memory  a block mapped from the system, released with the object. Failure  one sentence that names the file.
#pragma once

#include <cstddef>
#include <string_view>

#include "platform/reservation/memory_reservation.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

/// Larger files are refused.
inline constexpr std::size_t kMaxFileTextBytes = 1 << 20;

class FileText {
public:
    [[nodiscard]] std::string_view view() const { return text_; }

private:
    friend base::Result<FileText, base::Error> read_file_text(const char* path);
    MemoryReservation block_;
    std::string_view text_;
};

[[nodiscard]] base::Result<FileText, base::Error> read_file_text(const char* path);

}  // namespace tedavis::platform
