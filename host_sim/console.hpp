/// The output of a command: its result on stdout (text, or JSON with --json), notes and progress on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <istream>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

namespace tedavis::host_sim {

class Console {
public:
    static constexpr std::chrono::milliseconds kBetweenLines{5000};

    /// The streams must outlive the console. `live` says that `notes` is a terminal: then progress is one line that is redrawn,
    /// else a line every few seconds.
    Console(std::ostream& results, std::ostream& notes, bool json, bool live)
        : results_(&results), notes_(&notes), json_(json), live_(live) {}

    /// The command's result, once: `json` with --json, else `text`; either gets a line end where it lacks one.
    void result(std::string_view text, std::string_view json);
    /// One sentence beside the result.
    void note(std::string_view message);
    /// Redraws one line in place, with the time left once it can be told: on every new percent, and once a second; where stderr
    /// is no terminal, says a line of its own after each `between_lines` of work. Another `what` is another piece of work.
    void progress(std::string_view what, std::uint64_t done, std::uint64_t total);
    /// Ends the progress line, so that what follows starts on its own.
    void progress_done();

    /// Says what this one says, but for the result: for a command that is a part of another one.
    [[nodiscard]] Console without_result() const;

    /// Where somebody can answer. Must outlive the console; null: nobody can.
    void set_answers(std::istream* answers) { answers_ = answers; }
    void set_between_lines(std::chrono::milliseconds between_lines) { between_lines_ = between_lines; }
    /// Asks and waits: true for an answer that begins with y, false also without one. Nothing where nobody can answer.
    [[nodiscard]] std::optional<bool> confirm(std::string_view question);

    [[nodiscard]] bool json() const { return json_; }

private:
    void write_line(std::ostream& stream, std::string_view text);
    void redraw(const std::string& line);

    std::ostream* results_;  ///< null: the result is not said
    std::ostream* notes_;
    std::istream* answers_ = nullptr;
    std::chrono::milliseconds between_lines_ = kBetweenLines;
    bool json_;
    bool live_;
    int shown_percent_ = -1;
    std::string shown_what_;
    std::size_t shown_length_ = 0;
    std::chrono::steady_clock::time_point begun_, drawn_;
};

}  // namespace tedavis::host_sim
