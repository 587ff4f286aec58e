/// An AsyncReader with one thread that reads a ByteSource in the order of submission.
///
/// Memory       allocated at construction. Thread  one caller; the source is read from the reader's own thread.
/// Destruction  waits for the read in progress; pending reads are dropped. The source must outlive the reader.
#pragma once

#include <cstdint>
#include <memory>

#include "render_core/base/error.hpp"
#include "render_core/base/ports/async_reader.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

struct ThreadReaderSettings {
    std::uint32_t tickets = 1;            ///< 1..base::kMaxReadTickets
    std::uint32_t queue = 1;              ///< pending reads, 1..tickets; more are refused
    void (*on_thread_start)() = nullptr;  ///< called once in the new thread
};

[[nodiscard]] base::Result<std::unique_ptr<base::AsyncReader>, base::Error> make_thread_reader(
    base::ByteSource& source, const ThreadReaderSettings& settings);

}  // namespace tedavis::platform
