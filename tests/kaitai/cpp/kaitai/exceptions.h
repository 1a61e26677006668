// Errors that mip.cpp raises; see kaitaistruct.h.
#pragma once
#include "kaitaistruct.h"

namespace kaitai {

template <class T>
struct validation_not_equal_error : std::runtime_error {
    validation_not_equal_error(const T &, const T &, kstream *, const std::string &where) : runtime_error(where) {
    }
};

template <class T>
struct validation_expr_error : std::runtime_error {
    validation_expr_error(const T &, kstream *, const std::string &where) : runtime_error(where) {
    }
};

} // namespace kaitai
