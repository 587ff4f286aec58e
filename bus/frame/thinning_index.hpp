/// Marks along a long recording, in memory of a fixed size: when it is full every second mark is dropped and the
/// spacing doubles, so the marks stay even over a recording of unknown length.
///
/// Marks are added in order of `newest`, the newest stamp of all that lies before the mark. What lies before a mark is
/// exactly what a run up to T has read, for the last mark with newest <= T and the frames behind it up to T.
/// Memory  the caller's span, which must outlive the index; Mark needs a member `base::Time newest`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/span.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::bus {

template <class Mark>
class ThinningIndex {
    static_assert(std::is_trivially_copyable_v<Mark>);

public:
    /// `stride` items lie between marks at first; at least two places are needed.
    ThinningIndex(base::Span<Mark> storage, std::uint64_t stride) : storage_(storage), stride_(stride) {
        TEDAVIS_CHECK(storage.size() >= 2 && stride > 0);
    }

    /// Whether a mark is due after `items` items have been read since the last one.
    [[nodiscard]] bool due(std::uint64_t items) const { return items >= stride_; }

    void add(const Mark& mark) {
        TEDAVIS_CHECK(size_ == 0 || mark.newest >= storage_[size_ - 1].newest);
        if (size_ == storage_.size()) thin();
        storage_[size_++] = mark;
    }

    /// The last mark whose past lies at or before `time`; null when there is none.
    [[nodiscard]] const Mark* at_or_before(base::Time time) const {
        std::size_t low = 0;
        std::size_t high = size_;
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            if (storage_[middle].newest <= time)
                low = middle + 1;
            else
                high = middle;
        }
        return low == 0 ? nullptr : &storage_[low - 1];
    }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::uint64_t stride() const { return stride_; }

private:
    void thin() {
        std::size_t kept = 0;
        for (std::size_t i = 1; i < size_; i += 2) storage_[kept++] = storage_[i];
        size_ = kept;
        stride_ *= 2;
    }

    base::Span<Mark> storage_;
    std::uint64_t stride_;
    std::size_t size_ = 0;
};

}  // namespace tedavis::bus
