#include "render_core/raytrace/stream/token_writer.hpp"

#include <algorithm>

namespace tedavis::raytrace {

void TokenWriter::literals(const std::uint32_t* words, std::uint32_t count) {
    if (count > stop_ - end_) return note(WriterFault::too_much);
    if (count > 0) std::memcpy(words_ + end_, words, count * sizeof *words);
    end_ += count;
}

void TokenWriter::call(TaskId task) {
    if (task >= network_.size()) return note(WriterFault::unknown_task);
    const bool continues = pending_count_ > 0 && pending_task_ == task && end_ - pending_place_ == network_.task(task).arguments;
    if (!continues || pending_count_ == network_.most_count(task)) {
        if (!make_pending(task)) return;
    }
    ++pending_count_;
    pending_place_ = end_;
}

void TokenWriter::calls(TaskId task, const void* records, std::uint32_t count) {
    if (task >= network_.size()) return note(WriterFault::unknown_task);
    const std::uint32_t arguments = network_.task(task).arguments, most = network_.most_count(task);
    const unsigned char* from = static_cast<const unsigned char*>(records);
    while (count > 0) {
        const bool continues = pending_count_ > 0 && pending_task_ == task && end_ == pending_place_ && pending_count_ < most;
        const std::uint32_t now = std::min(count, most - (continues ? pending_count_ : 0));
        const std::size_t bytes = arguments * sizeof *words_;
        std::uint32_t* place = place_calls(task, now, bytes);
        if (place == nullptr) return;
        if (bytes > 0) std::memcpy(place, from, now * bytes);
        from += now * bytes;
        count -= now;
    }
}

std::uint32_t* TokenWriter::place_calls(TaskId task, std::uint32_t count, std::size_t bytes) {
    if (task >= network_.size()) {
        note(WriterFault::unknown_task);
        return nullptr;
    }
    const std::uint32_t arguments = network_.task(task).arguments, most = network_.most_count(task);
    TEDAVIS_CHECK(bytes == arguments * sizeof *words_ && count <= most);
    const bool continues =
        pending_count_ > 0 && pending_task_ == task && end_ == pending_place_ && pending_count_ + count <= most;
    if (count > 0 && !continues && !make_pending(task)) return nullptr;
    if (count * arguments > stop_ - end_) {
        note(WriterFault::too_much);
        return nullptr;
    }
    std::uint32_t* place = words_ + end_;
    end_ += count * arguments;
    if (count > 0) pending_place_ = end_;
    pending_count_ += count;
    return place;
}

void TokenWriter::each_calls(TaskId task, const void* records, std::uint32_t count) {
    if (task >= network_.size()) return note(WriterFault::unknown_task);
    const std::size_t record = network_.task(task).arguments * sizeof *words_;
    const unsigned char* from = static_cast<const unsigned char*>(records);
    count = std::min(count, borders_.empty() ? 0 : borders_[borders_.size() - 1] - done_);
    while (count > 0) {
        const std::uint32_t now = std::min(count, together());
        calls(task, from, now);
        done(now);
        from += now * record;
        count -= now;
    }
}

void TokenWriter::begin(base::Span<const std::uint32_t> borders, WrittenRun* runs, std::uint32_t most_outputs) {
    borders_ = borders;
    runs_ = runs;
    most_outputs_ = most_outputs;
    run_ = done_ = 0;
    border_ = borders.empty() ? 0 : borders[0];
    run_word_ = end_;
    run_call_ = calls_;
}

void TokenWriter::finish() {
    const std::uint32_t all = borders_.empty() ? 0 : borders_[borders_.size() - 1];
    if (done_ > all || (done_ < all && (end_ > run_word_ || pending_count_ > 0))) note(WriterFault::nobody);
    while (run_ < borders_.size()) {
        done_ = border_;
        close_run();
    }
}

void TokenWriter::clear() {
    end_ = calls_ = pending_count_ = pending_place_ = 0;
    stop_ = limit_;
}

bool TokenWriter::make_pending(TaskId task) {
    write_pending();
    if (end_ >= limit_) {
        note(WriterFault::too_much);
        return false;
    }
    pending_task_ = task;
    pending_place_ = end_;
    stop_ = limit_ - 1;
    return true;
}

void TokenWriter::write_pending() {
    stop_ = limit_;
    if (pending_count_ == 0) return;
    const std::uint32_t behind = end_ - pending_place_;
    std::uint32_t* place = words_ + pending_place_;
    if (behind > 0) std::memmove(place + 1, place, behind * sizeof *place);
    *place = call_word(pending_task_, pending_count_);
    call_places_[calls_++] = static_cast<std::uint16_t>(pending_place_);
    ++end_;
    pending_count_ = 0;
}

void TokenWriter::close_run() {
    write_pending();
    if (run_ >= borders_.size()) return;
    const std::uint32_t calls_of_run = border_ - (run_ == 0 ? 0 : borders_[run_ - 1]);
    if (end_ - run_word_ > calls_of_run * most_outputs_) {
        note(WriterFault::too_much);
        end_ = run_word_;
        calls_ = run_call_;
    }
    runs_[run_] = {run_word_, end_ - run_word_, run_call_, calls_ - run_call_};
    run_word_ = end_;
    run_call_ = calls_;
    if (++run_ < borders_.size()) border_ = borders_[run_];
}

}  // namespace tedavis::raytrace
