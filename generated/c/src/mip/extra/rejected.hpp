/**
 * @file
 * The field for which a device has rejected a command, in C++17: see mip/extra/rejected.h.
 */
#ifndef MIP_REJECTED_HPP
#define MIP_REJECTED_HPP

#include "mip/cpp/core.hpp"
#include "mip/extra/rejected.h"

namespace mip {

/** Why a device rejects a field. */
enum class rejection {
    /** Nothing shows the field. */
    unknown = MIP_REJECTION_UNKNOWN,
    /** The device does not send it. */
    absent = MIP_REJECTION_ABSENT,
    /** Its decimation is 0. */
    decimation = MIP_REJECTION_DECIMATION,
    /** The list is longer than permitted. */
    too_many = MIP_REJECTION_TOO_MANY,
    /** It is not data of the set. */
    undefined = MIP_REJECTION_UNDEFINED,
    /** No source states that this model sends it. */
    unlisted = MIP_REJECTION_UNLISTED,
    /** The device has another command for it, whose set and descriptor are stated. */
    other_command = MIP_REJECTION_OTHER_COMMAND
};

/** The field for which a device has rejected a command, or the command that it has instead. It is
 * false if nothing shows it. */
struct rejected_field : mip_rejected {
    rejected_field(const mip_rejected &other) : mip_rejected(other) {
    }
    explicit operator bool() const {
        return why() != rejection::unknown;
    }
    /** Returns the reason. */
    rejection why() const {
        return static_cast<rejection>(reason);
    }
    /** Writes the reason in words: "3DM-CV7-AR has no GNSS receiver". See mip_rejected_text. */
    template <std::size_t Size>
    std::string_view text(char (&room)[Size], const mip_known_device &known) const {
        const std::size_t size = mip_rejected_text(this, &known, room, Size);
        return {room, size < Size ? size : Size - 1};
    }
};

/** Finds the field for which a device has rejected a command, or the command that it has instead.
 * The command is `write_...{}`, or a C structure. */
template <class Command>
rejected_field find_rejected(const Command &command, const mip_known_device &known) {
    builder built(traits<typename detail::sent<Command>::structure>::codec().descriptor_set);
    mip_field sent = {nullptr, 0, 0, 0}; /* of no command, if it cannot be encoded */
    if (built.add(command) == MIP_OK) {
        sent = *built.finish().begin();
    }
    return mip_find_rejected(&sent, &known);
}

} // namespace mip

#endif
