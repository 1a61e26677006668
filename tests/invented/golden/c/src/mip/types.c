/* Types that more than one descriptor set uses. */
#include "mip/types.h"

void mip_point_read(struct mip_reader *r, struct mip_point *v) {
    mip_read_s16(r, &v->x, 1);
    mip_read_s16(r, &v->y, 1);
}

void mip_point_write(struct mip_writer *w, const struct mip_point *v) {
    mip_write_s16(w, &v->x, 1);
    mip_write_s16(w, &v->y, 1);
}

void mip_segment_read(struct mip_reader *r, struct mip_segment *v) {
    mip_point_read(r, &v->from);
    mip_point_read(r, &v->to);
    mip_read_u8(r, v->weights, 2);
}

void mip_segment_write(struct mip_writer *w, const struct mip_segment *v) {
    mip_point_write(w, &v->from);
    mip_point_write(w, &v->to);
    mip_write_u8(w, v->weights, 2);
}
