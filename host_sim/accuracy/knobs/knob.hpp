/// A setting of the product that trades accuracy for time: its levels, the reference of their errors, and how a level is run.
///
/// Everything that a reader of the report needs to believe a figure is a member that has no default, so a knob that does not
/// state it does not compile; a test with fault_of() (knob_registry.hpp) refuses what is stated but empty or not credible.
///
/// Some settings have one level only. They are knobs too, so that the report shows what this level's error is, and what the
/// alternatives would cost: the first level is the product's, the others are alternatives that it does not offer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// A text that must be given.
class Statement {
public:
    Statement(const char* text) : text_(text) {}             // NOLINT(google-explicit-constructor): stands where a text does
    Statement(std::string text) : text_(std::move(text)) {}  // NOLINT(google-explicit-constructor)
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

/// The reference that is taken as true, and a bound of its own error in the metric's unit.
class KnobReference {
public:
    KnobReference(Statement what, double error_bound, Statement reason)
        : what_(std::move(what)), reason_(std::move(reason)), error_bound_(error_bound) {}

    [[nodiscard]] const std::string& what() const { return what_.text(); }
    [[nodiscard]] const std::string& reason() const { return reason_.text(); }  ///< of the bound
    [[nodiscard]] double error_bound() const { return error_bound_; }

private:
    Statement what_, reason_;
    double error_bound_;
};

/// error ~ amount^exponent, as the literature or an earlier measurement has it.
struct ExpectedLaw {
    double exponent, tolerance;
    Statement source;
};

/// The things that a level processes, such as triangles or texels, if their number is more informative than the time.
struct KnobWork {
    Statement thing;  ///< plural
    ExpectedLaw law;  ///< of their number over the amount
};

struct KnobLevel {
    Statement name;  ///< as the user writes it
    double amount;   ///< abscissa of the fitted laws; 0: the level is on no scale
};

struct KnobFacts {
    Statement name;          ///< of --knob; lower case, underscores
    Statement title;         ///< for people
    Statement setting;       ///< where the product has it
    Statement metric, unit;  ///< what is measured as an error, and its unit
    KnobReference reference;
    Statement second_oracle;         ///< an independent second reference, or "none: " and why
    Statement never_trades;          ///< what no level changes
    Statement amount;                ///< what KnobLevel::amount counts
    std::optional<ExpectedLaw> law;  ///< nothing: none is known
    std::vector<KnobLevel> levels;   ///< the cheapest first; where `only_level` is stated, the product's first
    /// Why the product offers the first level and none of the others; nothing: it offers all.
    std::optional<Statement> only_level = std::nullopt;
    std::optional<KnobWork> work = std::nullopt;
};

/// From the left and from the top of a picture.
struct KnobPixel {
    std::uint32_t x = 0, y = 0;
};

/// A knob over inputs that were prepared when it was made. One thread.
class Knob {
public:
    explicit Knob(KnobFacts facts) : facts_(std::move(facts)) {}
    virtual ~Knob() = default;
    Knob(const Knob&) = delete;
    Knob& operator=(const Knob&) = delete;

    [[nodiscard]] const KnobFacts& facts() const { return facts_; }
    /// Number of pieces of work, each of which is timed alone.
    [[nodiscard]] virtual std::size_t samples() const = 0;
    /// Number of further pieces of work, numbered from samples() on, spread over the whole flight. They are timed at one level,
    /// to compare the slowest of them with the slowest sample; their errors are not measured.
    [[nodiscard]] virtual std::size_t moments() const { return 0; }
    /// Called before run() of the same sample and not timed: loads what a user does not wait for.
    virtual void prepare(std::size_t /*level*/, std::size_t /*sample*/) {}
    /// Does the work of a sample at a level: this is what is timed, and nothing else.
    virtual void run(std::size_t level, std::size_t sample) = 0;
    /// Appends the errors of the result of run(), 0 or more, in the metric's unit.
    virtual void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) = 0;
    /// Where an error of find_errors() is, for people: a ray, a pixel, a pose.
    [[nodiscard]] virtual std::string place_of(std::size_t sample, std::size_t error) const = 0;
    /// The picture of a sample at a level, for knobs that draw one; nothing for others.
    [[nodiscard]] virtual std::optional<RgbaPicture> picture(std::size_t /*level*/, std::size_t /*sample*/) {
        return std::nullopt;
    }
    /// Where an error of find_errors() is in that picture; nothing for knobs that draw none.
    [[nodiscard]] virtual std::optional<KnobPixel> pixel_of(std::size_t /*sample*/, std::size_t /*error*/) const {
        return std::nullopt;
    }
    /// The command that gives a sample at a level again.
    [[nodiscard]] virtual std::string command(std::size_t /*level*/, std::size_t /*sample*/) const {
        return "tedavis accuracy --knob " + facts_.name.text() + " -o DIR";
    }
    /// The greatest error that the product itself states for the samples of a level, such as a display's proven bound; nothing
    /// where it states none. After find_errors() of all samples.
    [[nodiscard]] virtual std::optional<double> proven(std::size_t /*level*/) const { return std::nullopt; }
    /// The options of `tedavis replay` that give a level; empty where no options do.
    [[nodiscard]] virtual std::string options(std::size_t /*level*/) const { return ""; }
    /// Mean number of the things of facts().work in a sample; after find_errors() of all samples.
    [[nodiscard]] virtual double work(std::size_t /*level*/) const { return 0; }
    /// Memory in bytes that a level takes in addition to that of all levels.
    [[nodiscard]] virtual std::uint64_t bytes(std::size_t /*level*/) const { return 0; }
    /// Bytes that a frame of a level uploads to the GPU; nothing for knobs that do not draw with it. Valid after run().
    [[nodiscard]] virtual std::optional<std::uint64_t> uploaded_bytes(std::size_t /*level*/) const { return std::nullopt; }
    /// Time of the preparations of a level, once before the first sample.
    [[nodiscard]] virtual double build_ms(std::size_t /*level*/) const { return 0; }

private:
    KnobFacts facts_;
};

}  // namespace tedavis::host_sim
