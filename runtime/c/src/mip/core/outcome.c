/* The outcome of a command, in words. */
#include "mip/device.h"
#include "mip/types.h"

const char *mip_outcome_name(enum mip_outcome outcome) {
    switch (outcome) {
    case MIP_NOT_SENT:
        return "not sent";
    case MIP_ACKNOWLEDGED:
        return "acknowledged";
    case MIP_SENT:
        return "sent";
    case MIP_REFUSED:
        return "refused";
    case MIP_TIMED_OUT:
        return "timed out";
    case MIP_MISSING_RESPONSE:
        return "missing response";
    case MIP_UNDECODABLE:
        return "undecodable";
    case MIP_CLOSED:
        return "closed";
    case MIP_BUSY:
        return "busy";
    case MIP_NO_SUCH_RATE:
        return "no such rate";
    case MIP_WAITING:
        return "waiting";
    }
    return "unknown";
}

const char *mip_result_reason(struct mip_result result) {
    const char *name = "";
    if (result.outcome == MIP_REFUSED) {
        name = mip_ack_code_name(result.code);
        return name != NULL ? name : "unknown";
    }
    return result.error != MIP_OK ? mip_error_name((mip_error)result.error) : "";
}
