/// Hands the record of each frame to programs on the same machine: a socket in the file system (SOCK_SEQPACKET), one JSON object
/// a packet. Who connects reads from the next frame on.
///
/// Never waits. A reader that does not keep up misses records, which it sees by their frame numbers; one that has taken none of
/// kMaxMissed in a row is left, so that others get its place.
///
/// Thread  one. Memory  inside; nothing after start(). Failure  start() returns one sentence.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "render_core/base/error.hpp"
#include "target/board_config.hpp"

namespace tedavis::target {

class RecordSocket {
public:
    static constexpr std::size_t kMaxReaders = 4;     ///< further ones are refused
    static constexpr std::uint32_t kMaxMissed = 300;  ///< ten seconds at 30 frames a second

    RecordSocket() = default;
    ~RecordSocket();
    RecordSocket(const RecordSocket&) = delete;
    RecordSocket& operator=(const RecordSocket&) = delete;

    /// Makes the socket at `path`, for its user and group; one that an ended program has left there is replaced.
    [[nodiscard]] base::Error start(const Path& path);
    [[nodiscard]] bool is_started() const { return listener_ >= 0; }
    /// Takes the programs that wait. True where there is one to read the next record.
    [[nodiscard]] bool has_readers();
    /// A reader that has left, or that the record is too large for, is forgotten.
    void send(std::string_view record);

private:
    [[nodiscard]] base::Error bind_at(const Path& path);

    int listener_ = -1;
    Path path_;
    struct Reader {
        int descriptor = -1;
        std::uint32_t missed = 0;  ///< records in a row
    };
    [[nodiscard]] static bool takes(Reader& reader, std::string_view record);
    std::array<Reader, kMaxReaders> readers_;
    std::size_t count_ = 0;
};

}  // namespace tedavis::target
