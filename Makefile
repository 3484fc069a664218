# make            builds every chapter into build/
# make run        runs every chapter: draws into images/, prints every table     run-NN  only one
# make test       all tests, one a core; the last line counts them    test-NN, test-vec3 ... some
# make precision  every chapter in float and in double: error and time side by side
# make images     copies the plots of measured times from build/ into images/
# make graph      which chapter includes which
# make sanitize   all tests under AddressSanitizer and UBSan, with a tenth of the counts
# make clean      removes build/                                                 help    this text
#
# Variables: CC (cc), CFLAGS (-O3, and -march=native where it works), REAL (double or float),
# LDLIBS, V=1 shows the commands, JOBS (compilers and tests at a time, all cores).
# Example: make clean test CC=clang REAL=float CFLAGS=-O2

NATIVE := $(shell $(CC) -march=native -x c -c -o /dev/null /dev/null 2>/dev/null && echo -march=native)
CFLAGS ?= -O3 $(NATIVE)
LDLIBS ?= -lm -lpthread
REAL ?= double
WARN = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
# Contraction into fma would break exact antisymmetry (04); gcc 12's SLP vectoriser skips roundings.
EXACT = -ffp-contract=off -fno-tree-slp-vectorize
ALL_CFLAGS = -std=c11 $(CFLAGS) $(EXACT) $(WARN) -DREAL=$(REAL) -DBUILD_FLAGS='"$(strip $(CFLAGS) $(EXACT))"'

BUILD ?= build
# Objects of other flags are other objects: each set has its own stamp, and a change rebuilds.
STAMP := $(BUILD)/flags
MAINS := $(sort $(wildcard chapters/*/main.c))
CHAPTERS := $(patsubst chapters/%/main.c,%,$(MAINS))
NUMBERS := $(foreach c,$(CHAPTERS),$(firstword $(subst _, ,$(c))))
TESTS := $(patsubst tests/%.c,%,$(sort $(wildcard tests/*.c)))
TEST_NUMBERS := $(sort $(foreach t,$(TESTS),$(firstword $(subst _, ,$(t)))))
Q := $(if $(V),,@)
# What only builds and tests takes all cores; make's own -j goes before. Programs run one by one.
JOBS ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
ifeq ($(MAKELEVEL)$(filter-out all test test-% sanitize precision,$(MAKECMDGOALS)),0)
MAKEFLAGS += -j$(JOBS)
endif

.PHONY: all run images test precision graph sanitize clean help FORCE
all: $(CHAPTERS:%=$(BUILD)/%)

$(BUILD)/%: chapters/%/main.c $(STAMP)
	$(if $(V),,@echo "CC $*")
	$(Q)$(CC) $(ALL_CFLAGS) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)

$(BUILD)/test_%: tests/%.c $(STAMP)
	$(if $(V),,@echo "CC tests/$*")
	$(Q)$(CC) $(ALL_CFLAGS) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)

-include $(wildcard $(BUILD)/*.d)

$(STAMP): FORCE
	@mkdir -p $(BUILD)
	@echo '$(CC) $(ALL_CFLAGS) $(LDLIBS)' | cmp -s - $@ || echo '$(CC) $(ALL_CFLAGS) $(LDLIBS)' > $@
FORCE:

run: $(CHAPTERS:%=run-%)
$(CHAPTERS:%=run-%): run-%: $(BUILD)/%
	@echo; echo "== $*"
	$(Q)$(BUILD)/$*
define run_number
.PHONY: run-$(1)
run-$(1): $(addprefix run-,$(filter $(1)_%,$(CHAPTERS)))
endef
$(foreach n,$(NUMBERS),$(eval $(call run_number,$(n))))
.PHONY: $(CHAPTERS:%=run-%)

images: run
	cp $(BUILD)/*_time.svg images/

test: all $(TESTS:%=$(BUILD)/test_%)
	@CC="$(CC)" BUILD="$(BUILD)" REAL="$(REAL)" JOBS="$(JOBS)" sh tests/run.sh cli.sh rules.sh $(TESTS)
define test_number
.PHONY: test-$(1)
test-$(1): $(addprefix $(BUILD)/,$(filter $(1)_%,$(CHAPTERS)) $(patsubst %,test_%,$(filter $(1) $(1)_%,$(TESTS))))
	@CC="$(CC)" BUILD="$(BUILD)" REAL="$(REAL)" JOBS="$(JOBS)" sh tests/run.sh $(filter $(1) $(1)_%,$(TESTS))
endef
$(foreach n,$(TEST_NUMBERS),$(eval $(call test_number,$(n))))

precision:
	$(Q)$(MAKE) --no-print-directory BUILD=$(BUILD)/double REAL=double all
	$(Q)$(MAKE) --no-print-directory BUILD=$(BUILD)/float REAL=float all
	@BUILD="$(BUILD)" sh tests/precision.sh $(CHAPTERS)

graph:
	@sh tests/rules.sh graph

sanitize:
	$(Q)CHECK_DIVISOR=10 $(MAKE) --no-print-directory BUILD=$(BUILD)/sanitize test \
	  CFLAGS="-O0 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"

clean:
	rm -rf $(BUILD)

help:
	@sed -n '/^#/!q; s/^# \{0,1\}//p' Makefile
