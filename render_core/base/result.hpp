/// A value or the error that prevented it, without exceptions.
///
/// Both alternatives are stored side by side, so T and E must be default-constructible; that keeps the type trivially
/// copyable when T and E are. Reading the wrong alternative is a broken invariant and stops the program.
#pragma once

#include <utility>

#include "render_core/base/check.hpp"

namespace tedavis::base {

template <class E>
struct Failure {
    E error;
};

template <class E>
[[nodiscard]] Failure<E> fail(E error) {
    return Failure<E>{std::move(error)};
}

template <class T, class E>
class [[nodiscard]] Result {
public:
    Result(T value) : value_(std::move(value)), has_value_(true) {}
    Result(Failure<E> failure) : error_(std::move(failure.error)) {}

    [[nodiscard]] bool ok() const { return has_value_; }
    explicit operator bool() const { return has_value_; }

    [[nodiscard]] T& value() {
        TEDAVIS_CHECK(has_value_);
        return value_;
    }
    [[nodiscard]] const T& value() const {
        TEDAVIS_CHECK(has_value_);
        return value_;
    }
    [[nodiscard]] const E& error() const {
        TEDAVIS_CHECK(!has_value_);
        return error_;
    }

private:
    T value_{};
    E error_{};
    bool has_value_ = false;
};

}  // namespace tedavis::base
