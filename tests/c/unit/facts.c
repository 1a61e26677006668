/* Prints what the tables say: of devices, and of every parameter of every field. */
#include "check.h"

#include "mip/devices.h"
#include "mip/reflect.h"
#include "mip/registry.h"

static void devices(void) {
    for (size_t i = 0; i < mip_device_count; i++) {
        const struct mip_device *d = mip_devices[i];
        printf("device\t%s\t%s\t%s\t%s\t%u\n", d->id, d->title, d->manual, d->description, d->model_number);
        for (unsigned set = 0; set < 256; set++) {
            const double rate = mip_device_base_rate(d, (uint8_t)set);
            if (rate >= 0) {
                printf("rate\t%s\t%u\t%.17g\n", d->id, set, rate);
            }
            for (unsigned descriptor = 0; descriptor < 256; descriptor++) {
                const struct mip_device_field *f = mip_device_supports(d, (uint8_t)set, (uint8_t)descriptor);
                if (f != NULL) {
                    printf("field\t%s\t%u\t%u\t%s\n", d->id, set, descriptor, f->functions);
                }
            }
        }
        for (size_t k = 0; k < d->port_count; k++) {
            const struct mip_device_port *p = &d->ports[k];
            printf("port\t%s\t%s\t%u\t%s\t", d->id, p->name, p->id, p->protocols);
            for (size_t n = 0; n < p->baud_rate_count; n++) {
                printf("%lu ", (unsigned long)p->baud_rates[n]);
            }
            printf("\n");
        }
        for (size_t k = 0; k < d->limit_count; k++) {
            const struct mip_device_limit *l = &d->limits[k];
            printf("limit\t%s\t%s\t%.17g\t%s\t%s\n", d->id, l->name, l->value, l->unit, l->description);
        }
        for (size_t k = 0; k < d->note_count; k++) {
            const struct mip_device_note *n = &d->notes[k];
            printf("note\t%s\t%s\t%s\t%s\t%u\t%u", d->id, n->name, n->title, n->description, n->rows, n->columns);
            for (size_t c = 0; c < (size_t)n->rows * n->columns; c++) {
                printf("\t%s", n->cells[c]);
            }
            printf("\n");
        }
        for (size_t k = 0; k < d->reading_count; k++) {
            printf("reading\t%s\t%s\t%s\n", d->id, d->readings[k].of, d->readings[k].type);
        }
        for (size_t k = 0; k < d->ack_code_count; k++) {
            printf("code\t%s\t%u\n", d->id, d->ack_codes[k]);
        }
    }
}

static void parameters(const struct mip_parameter *p, size_t count, const char *path) {
    for (size_t i = 0; i < count; i++, p++) {
        char name[256];
        CHECK(snprintf(name, sizeof(name), "%s.%s", path, p->name) < (int)sizeof(name));
        printf("parameter\t%s\t%s\t%u\t%u\t%s\n", name, p->unit, p->capacity, p->elements,
               p->names != NULL ? p->names->name : "");
        if (p->record != NULL) {
            parameters(p->record->parameters, p->record->count, name);
        }
        for (size_t k = 0; k < p->count; k++) {
            if (p->cases != NULL && p->cases[k].parameter != NULL) {
                parameters(p->cases[k].parameter, 1, name);
            } else if (p->cases == NULL) {
                printf("reading\t%s\t%s\n", name, p->readings[k].names->name);
            }
        }
    }
}

int main(void) {
    devices();
    for (size_t i = 0; i < mip_registry_size; i++) {
        const struct mip_record *r = mip_reflect(mip_registry[i].codec)->record;
        parameters(r->parameters, r->count, mip_registry[i].name);
    }
    return 0;
}
