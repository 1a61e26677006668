/* The names of errors. */
#include "mip/core.h"

const char *mip_error_name(mip_error error) {
    switch (error) {
    case MIP_OK:
        return "ok";
    case MIP_ERROR_SYNC:
        return "sync";
    case MIP_ERROR_LENGTH:
        return "length";
    case MIP_ERROR_CHECKSUM:
        return "checksum";
    case MIP_ERROR_FIELD_LENGTH:
        return "field_length";
    case MIP_ERROR_TRUNCATED:
        return "truncated";
    case MIP_ERROR_COUNT:
        return "count";
    case MIP_ERROR_CONSTANT:
        return "constant";
    case MIP_ERROR_MISSING:
        return "missing";
    case MIP_ERROR_SET:
        return "set";
    case MIP_ERROR_DESCRIPTOR:
        return "descriptor";
    case MIP_ERROR_LAYOUT:
        return "layout";
    }
    return "unknown";
}
