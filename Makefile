# make            builds every chapter into build/
# make first      the short book: builds and runs the first program of every chapter  first-NN  only one
# make run        the short book, then every chapter: draws into images/, a screen of text each    run-NN  only one
# make full       every chapter with --full: all tables and plots of the pages   full-NN  only one
# make test       all tests, one a core; the last line counts them    test-NN, test-vec3 ... some
# make soak       all tables, and all tests with eight times the counts   MINUTES=30: half an hour of random numbers
# make tax        what being general costs 27, against 18, 19 and 26, and a verdict; the table is part of full-27
# make pages      the tables of all pages against what the programs print   FULL=1: print with --full
# make precision  every chapter in float and in double: error and time side by side
# make images     make full, and copies the plots of measured times from build/ into images/
# make showpiece  the picture on top of README.md, some minutes: images/showpiece.png
# make graph      which chapter includes which
# make notes      the ledger: what the lecture notes claim, and what the programs find   a minute or so
# make book       all pages as one file, build/book.html, for reading offline (needs pandoc)
# make hard-cases hard inputs of all chapters: wrong answers of the first versions and of the default
# make costs      what accuracy costs, all chapters in one plot: images/costs.svg, and its table
# make bugs       planted bugs, by symptom   bug-07: find it   bug-07 TEST=my_test.c: does it catch it?   bug-07-answer
# make mine-04    your own function beside ours: MINE=my.h; sphere mine-03, triangle 04, box 09, structure 17
# make commands   every command of the texts, as printed, in a fresh clone   some minutes
# make coverage   gcov: lines and branches of the headers that the tests pass   TESTS=".."
# make compilers  does a picture depend on the compiler? gcc and clang, -O0 to -O3, half an hour   FILES=".."
# make mutants    breaks headers in one place at a time: do the tests see it?   FILES=".." SEED=1 N=20
# make assignment-04  homework to give out: build/assignment-04/   assignment SET="04 09 14 26"  a set
# make grade SUBMISSION=folder  a table, build/results.json   SUBMISSIONS=..  a class, build/grades.csv
# make embree     15 against Embree 3, where that is installed (Debian: libembree-dev)
# make tidy       clang-tidy over all programs and tests, as .clang-tidy says: no findings   (needs clang-tidy)
# make sanitize   all tests under AddressSanitizer and UBSan, with a tenth of the counts
# make valgrind   reads of what nobody wrote: the tests that .ci/run does not ask for them   TESTS=".."  these
# make clean      removes build/                                                 help    this text
#
# Variables: CC (cc), CFLAGS (-O2, and -march=native where it works), REAL (double or float),
# LDLIBS, V=1 shows the commands, JOBS (compilers and tests at a time, all cores).
# Example: make clean test CC=clang REAL=float CFLAGS=-O2

# What the compiler knows. The makes that this one calls inherit the answers.
ifneq ($(ASKED),$(CC))
NATIVE := $(shell $(CC) -march=native -x c -c -o /dev/null /dev/null 2>/dev/null && echo -march=native)
# For some processors gcc 12 hands structs to functions by wide registers and leaves their upper halves full: then
# each call of libm or libgcc, which are not compiled for AVX, waits (07's winding number: 700 ns a triangle instead of 17).
NATIVE += $(if $(NATIVE),$(shell $(CC) -Werror -mmove-max=128 -mstore-max=128 -x c -c -o /dev/null /dev/null \
  2>/dev/null && echo -mmove-max=128 -mstore-max=128))
# For the first Zen gcc makes two halves of eight floats, which meet in memory: 14 takes a quarter longer to build.
NATIVE += $(if $(NATIVE),$(shell $(CC) -Werror -mprefer-vector-width=256 -x c -c -o /dev/null /dev/null \
  2>/dev/null && echo -mprefer-vector-width=256))
# Two passes that take an eighth of the compiler's time; without them programs run as fast (09: a twenty-fifth slower).
LEAN := $(shell $(CC) -Werror -fno-gcse -fno-schedule-insns2 -x c -c -o /dev/null /dev/null 2>/dev/null && \
  echo -fno-gcse -fno-schedule-insns2)
# Below -O2 gcc leaves the upper halves of wide registers full everywhere, unless this is asked for (17_torture: 76 s
# instead of 3).
CLEAR := $(shell $(CC) -Werror -fexpensive-optimizations -x c -c -o /dev/null /dev/null 2>/dev/null && \
  echo -fexpensive-optimizations)
# Passes that take an eighth of -O1's time, for nearly as fast tests.
FEW := $(shell $(CC) -Werror -fira-region=one -fno-tree-pta -fno-tree-dominator-opts -fno-dse -fno-ivopts -fno-tree-sink \
  -fno-shrink-wrap -x c -c -o /dev/null /dev/null 2>/dev/null && echo -fira-region=one -fno-tree-pta \
  -fno-tree-dominator-opts -fno-dse -fno-ivopts -fno-tree-sink -fno-shrink-wrap)
CALM := $(shell echo 'int x;' | $(CC) -Werror -Wno-maybe-uninitialized -x c -c -o /dev/null - 2>/dev/null && \
  echo -Wno-maybe-uninitialized)
SMALL := $(shell $(CC) -Werror --param inline-unit-growth=0 --param large-unit-insns=0 -x c -c -o /dev/null /dev/null \
  2>/dev/null && echo --param inline-unit-growth=0 --param large-unit-insns=0)
export NATIVE LEAN CLEAR FEW CALM SMALL
export ASKED := $(CC)
endif

# First programs, tests, and the programs that tests run: -O1 halves the compiler's time, and theirs is nearly
# the same; -O0 makes the tests of common/, which compute little, sooner. CFLAGS, if given, goes before.
ifeq ($(origin CFLAGS),undefined)
QUICK_CFLAGS ?= -O1 -fno-math-errno $(CLEAR) $(FEW)
FIRST_CFLAGS = -O1 -fno-math-errno  # sqrt is no call then; for no processor in particular: CLEAR would only cost time
FIRST_FAST = 05_implicit 15_wide_bvh  # -O2 halves their time
SET_CFLAGS_common = -O0 $(CLEAR)
# What tests themselves say computes little beside what they call: a fifth of the compiler's time.
SET_TEXTS = O0
endif
CFLAGS ?= -O2 $(LEAN) $(NATIVE)
QUICK_CFLAGS ?= $(CFLAGS)
FIRST_CFLAGS ?= $(QUICK_CFLAGS)
LDLIBS ?= -lm -lpthread
REAL ?= double
# first.h and first.c say 0.5 where real may be float: there two warnings would be noise. Where it is
# double they say nothing of them; where it is float, rules.sh asks all other files.
WARN_FIRST = -Wall -Wextra -Wpedantic -Wshadow
# Where a constant of an enum is a number beside others new versions of clang warn, too: of some hundred of these.
WARN = $(WARN_FIRST) $(if $(filter double,$(REAL)),-Wconversion -Wno-enum-float-conversion -Wdouble-promotion)
# Contraction into fma would break exact antisymmetry (04); gcc 12's SLP vectoriser skips roundings.
EXACT = -ffp-contract=off -fno-tree-slp-vectorize
# What only tests need is compiled in half the time if nothing is inlined by force; the code is the same. (What gcc
# then takes for uninitialised, because it looks at fewer calls at once, it reads right with CFLAGS.)
# Nor does gcc put a function into another where the file grows by it: a fifth less of its time, and the tests run as
# long but for a thirtieth.
SOON = -Dflatten= -Dalways_inline=unused $(CALM) $(SMALL)
# Under the sanitizers: sets of tests that compute much for the few lines they compile, and the short book.
MUCH = structures first
ALL_CFLAGS = -std=c11 $(CFLAGS) $(EXACT) $(WARN) -DREAL=$(REAL) -DBUILD_FLAGS='"$(strip $(CFLAGS) $(EXACT))"'
ALL_FIRST_CFLAGS = -std=c11 $(FIRST_CFLAGS) $(MUCH_CFLAGS) $(EXACT) $(WARN_FIRST) -DREAL=$(REAL)

BUILD ?= build
ifneq ($(words $(filter-out / . ..,$(BUILD))) $(words $(filter double float,$(REAL))),1 1)
$(error BUILD is '$(BUILD)', REAL '$(REAL)': allowed are the name of a folder, without blanks; double, float)
endif
# Objects of other flags are other objects: each set has its own stamp, and a change rebuilds.
STAMP := $(BUILD)/flags
MAINS := $(sort $(wildcard chapters/*/main.c))
CHAPTERS := $(patsubst chapters/%/main.c,%,$(MAINS))
NUMBERS := $(foreach c,$(CHAPTERS),$(firstword $(subst _, ,$(c))))
FIRSTS := $(patsubst chapters/%/first.c,%,$(sort $(wildcard chapters/*/first.c)))
FIRST_NUMBERS := $(foreach c,$(FIRSTS),$(firstword $(subst _, ,$(c))))
TESTS := $(patsubst tests/%.c,%,$(sort $(wildcard tests/*.c)))
SCRIPTS = cli.sh faults.sh first.sh rules.sh names.sh pages.sh notes.sh bugs.sh
TEST_NUMBERS := $(sort $(foreach t,$(TESTS),$(firstword $(subst _, ,$(t)))))
Q := $(if $(V),,@)
# What only builds and tests takes all cores; make's own -j goes before. Programs run one by one.
JOBS ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
ifeq ($(MAKELEVEL)$(filter-out all test test-% soak pages sanitize precision,$(MAKECMDGOALS)),0)
MAKEFLAGS += -j$(JOBS)
endif

# So the makes that this one calls: as many, unless a -j of its own hands out the turns already.
J = $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS))
ifdef ONE_BY_ONE
.NOTPARALLEL:
endif

# Else the first rule, which the template below makes.
.DEFAULT_GOAL := all
# A compiler or linker that was ended in the midst leaves a file that is newer than its sources.
.DELETE_ON_ERROR:
.PHONY: all run full tax images showpiece test soak pages precision graph mutants bugs hard-cases csv costs book notes embree sanitize tidy clean help FORCE
# Programs that include much the same are built as one (tests/together.sh), of which each is a copy: what they include is
# compiled once, which halves the compiler's time. `make build/14_bvh` and `make run-14` build a program by itself: that
# is as quick on average, and up to a tenth off. Those that take longest come first, else one core waits at the end.
PARTS = structures paths light shapes
PART_structures = $(filter-out 18_% 19_%,$(filter 1%,$(CHAPTERS)))
PART_paths = $(filter 24_% 25_% 26_% 27_%,$(CHAPTERS))
PART_light = $(filter-out $(PART_structures) $(PART_paths) $(PART_shapes),$(CHAPTERS))
PART_shapes = $(filter 0%,$(CHAPTERS))
# The short book, in two parts as well.
FIRST_PARTS = second_half first_half
PART_first_half = $(filter 0% 10_% 11_% 12_% 13_%,$(FIRST_LEAN))
PART_second_half = $(filter-out $(PART_first_half),$(FIRST_LEAN))
FIRST_LEAN = $(patsubst %,%_first,$(filter-out $(FIRST_FAST),$(FIRSTS)))
# $(call together,PROGRAM,FLAGS,NAMES OF WHAT IT IS,TEXTS of together.sh)
define together
$(1).c: FORCE
	@mkdir -p $(dir $(1)) && TEXTS=$(4) sh tests/together.sh $(3) >$$@.new; cmp -s $$@.new $$@ && rm $$@.new || mv $$@.new $$@
$(1): $(1).c $(STAMP)
	$(if $(V),,@echo "CC $(3)")
	$(Q)$(CC) -I. $(2) -Wno-shadow -MMD -MP -MF $$@.d -MT "$$@ $(3:%=$(dir $(1))%)" -o $$@ $$< $(LDLIBS)
endef
# $(call copies,PARTS): those of their programs that are older than the part. A half copy (an interrupt, a full disk)
# would be newer, and stay; so it has another name until it is whole.
copies = $(foreach p,$(1),for c in $(PART_$(p)); do [ $(BUILD)/$$c -nt $(BUILD)/$(p) ] || \
  { cp $(BUILD)/$(p) $(BUILD)/$$c.new && mv -f $(BUILD)/$$c.new $(BUILD)/$$c; } || exit 1; done;)
$(foreach p,$(PARTS),$(eval $(call together,$(BUILD)/$(p),$(ALL_CFLAGS),$(PART_$(p)))))
$(foreach p,$(FIRST_PARTS),$(eval $(call together,$(BUILD)/$(p),$(ALL_FIRST_CFLAGS),$(PART_$(p)))))
.PHONY: firsts
all: $(PARTS:%=$(BUILD)/%)
	@$(call copies,$(PARTS))
firsts: $(foreach p,$(FIRST_PARTS),$(if $(PART_$(p)),$(BUILD)/$(p))) $(patsubst %,$(BUILD)/%_first,$(filter $(FIRST_FAST),$(FIRSTS)))
	@$(call copies,$(FIRST_PARTS))

$(BUILD)/%: chapters/%/main.c $(STAMP)
	$(if $(V),,@echo "CC $*")
	$(Q)$(CC) $(ALL_CFLAGS) $(if $(MINE),-DMINE='"$(MINE)"') -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)

$(BUILD)/27_tax: chapters/27_effects/lab/tax.c $(STAMP)
	$(if $(V),,@echo "CC 27_tax")
	$(Q)$(CC) $(ALL_CFLAGS) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)

# The same programs for `make test`, which needs them soon rather than fast.
$(BUILD)/quick/%: chapters/%/main.c $(STAMP)
	$(if $(V),,@echo "CC quick/$*")
	$(Q)$(CC) $(ALL_CFLAGS) $(if $(MINE),-DMINE='"$(MINE)"') $(QUICK_CFLAGS) $(SOON) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)

$(BUILD)/%_first: chapters/%/first.c $(STAMP)
	$(if $(V),,@echo "CC $*_first")
	$(Q)$(CC) $(ALL_FIRST_CFLAGS) $(if $(filter $*,$(FIRST_FAST)),-O2) -MMD -MP -MF $@.d -MT $@ -o $@ $< -lm

$(BUILD)/test_%: tests/%.c $(STAMP)
	$(if $(V),,@echo "CC tests/$*")
	$(Q)$(CC) $(ALL_CFLAGS) $(QUICK_CFLAGS) $(SOON) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)

-include $(wildcard $(BUILD)/*.d $(BUILD)/quick/*.d)

$(STAMP): FORCE
	@mkdir -p $(BUILD)/quick
	@echo '$(CC) $(ALL_CFLAGS) $(QUICK_CFLAGS) $(FIRST_CFLAGS) $(LDLIBS)' | cmp -s - $@ || \
	  echo '$(CC) $(ALL_CFLAGS) $(QUICK_CFLAGS) $(FIRST_CFLAGS) $(LDLIBS)' > $@
FORCE:

# Two at a time, or as many as there are cores; 17 measures time, and runs alone.
first:
	@echo "== the short book"
	$(Q)$(MAKE) --no-print-directory $(J) firsts
	$(Q)$(MAKE) --no-print-directory $(J) $(addprefix first-,$(filter-out 17_compare,$(FIRSTS)))
	$(Q)$(MAKE) --no-print-directory $(addprefix first-,$(filter 17_compare,$(FIRSTS)))
$(FIRSTS:%=first-%): first-%: $(BUILD)/%_first
	$(Q)$(BUILD)/$*_first
define first_number
.PHONY: first-$(1)
first-$(1): $(addprefix first-,$(filter $(1)_%,$(FIRSTS)))
endef
$(foreach n,$(FIRST_NUMBERS),$(eval $(call first_number,$(n))))
.PHONY: first $(FIRSTS:%=first-%)

# All cores build, then the programs run one by one: they measure time.
run: first
	$(Q)$(MAKE) --no-print-directory $(J) all
	$(Q)$(MAKE) --no-print-directory ONE_BY_ONE=yes $(CHAPTERS:%=run-%)
full:
	$(Q)$(MAKE) --no-print-directory $(J) all
	$(Q)$(MAKE) --no-print-directory ONE_BY_ONE=yes $(CHAPTERS:%=full-%)
$(CHAPTERS:%=run-%): run-%: $(BUILD)/%
	@echo; echo "== $*"
	$(Q)$(BUILD)/$*
$(CHAPTERS:%=full-%): full-%: $(BUILD)/%
	@echo; echo "== $* --full"
	$(Q)$(BUILD)/$* --full
	$(Q)$(if $(filter 27_%,$*),$(BUILD)/27_tax)
full-27_effects tax: $(BUILD)/27_tax
tax:
	$(Q)$(BUILD)/27_tax --verdict
define run_number
.PHONY: run-$(1) full-$(1)
run-$(1): $(addprefix run-,$(filter $(1)_%,$(CHAPTERS)))
full-$(1): $(addprefix full-,$(filter $(1)_%,$(CHAPTERS)))
endef
$(foreach n,$(NUMBERS),$(eval $(call run_number,$(n))))
.PHONY: $(CHAPTERS:%=run-%) $(CHAPTERS:%=full-%)

images: full
	cp $(BUILD)/*_time.svg images/
	$(BUILD)/26_path_tracer --scene spheres --samples 1024 --out images/26_path_tracer_spheres.png
	$(BUILD)/26_path_tracer --scene teapot --size 720x480 --samples 512 --out images/26_path_tracer_teapot.png
	$(BUILD)/27_effects chapters/27_effects/scenes/demo.scene --size 640x480 --samples 400 \
	  --out images/27_effects_demo.png
	$(BUILD)/27_effects chapters/27_effects/scenes/drink.scene --size 640x480 --samples 256 --out images/27_effects_drink.png

# The scene's teapot is finer than the one in 07's scenes/: 07 writes it, to where the scene looks for it.
showpiece: $(BUILD)/07_mesh $(BUILD)/27_effects
	@mkdir -p build
	$(Q)$(BUILD)/07_mesh --teapot 24 --save build/teapot.obj
	$(Q)$(BUILD)/27_effects chapters/27_effects/scenes/showpiece.scene --size 1280x720 --samples 256 --out images/showpiece.png

# Tests and programs of a part are one program there, with flags that have both, compiling and computing, done soonest.
# But two, which put a function of their own before pthread_create: what they include calls that.
ALONE = parallel 15_wide_bvh
SETS = structures light shapes paths first common
SET_first = $(filter %_first,$(TESTS))
# And the short book itself; its first.c count pixels with int.
PART_first = $(FIRSTS:%=%_first)
SET_WARN_first = -Wno-sign-conversion
SET_paths = $(filter 24_% 25_% 26_% 27_%,$(filter-out %_first,$(TESTS)))
SET_structures = $(filter-out $(ALONE) 17_spd 18_% 19_%,$(filter 1%,$(filter-out %_first,$(TESTS))))
SET_light = $(filter 17_spd 18_% 19_% 2%,$(filter-out $(SET_paths) %_first,$(TESTS)))
SET_shapes = $(filter 0%,$(filter-out %_first,$(TESTS)))
SET_common = $(filter-out $(ALONE) 0% 1% 2%,$(TESTS))
SET = $(SET_$(1):%=test_%) $(PART_$(1))
$(foreach s,$(SETS),$(eval $(call together,$(BUILD)/quick/$(s),$(ALL_CFLAGS) $(or $(SET_CFLAGS_$(s)),$(QUICK_CFLAGS)) \
  $(if $(filter $(s),$(MUCH)),$(MUCH_CFLAGS)) $(SOON) $(SET_WARN_$(s)),$(call SET,$(s)),$(SET_TEXTS))))

SINGLE = $(filter-out $(foreach s,$(SETS),$(SET_$(s))),$(TESTS))
test: $(foreach s,$(SETS),$(if $(strip $(call SET,$(s))),$(BUILD)/quick/$(s))) $(SINGLE:%=$(BUILD)/test_%)
	@cd $(BUILD)/quick && for f in $(SINGLE:%=test_%); do ln -sf ../$$f .; done; \
	  $(foreach s,$(SETS),for p in $(call SET,$(s)); do ln -sf $(s) $$p; done;)
	@CC="$(CC)" BUILD="$(BUILD)/quick" TESTS="$(BUILD)/quick" REAL="$(REAL)" JOBS="$(JOBS)" TABLES=no \
	  sh tests/run.sh $(SCRIPTS) $(TESTS)
define test_number
.PHONY: test-$(1)
test-$(1): $(addprefix $(BUILD)/,$(filter $(1)_%,$(CHAPTERS) $(FIRSTS:%=%_first)) $(patsubst %,test_%,$(filter $(1) $(1)_%,$(TESTS))))
	@CC="$(CC)" BUILD="$(BUILD)" REAL="$(REAL)" JOBS="$(JOBS)" sh tests/run.sh $(filter $(1) $(1)_%,$(TESTS))
endef
$(foreach n,$(TEST_NUMBERS),$(eval $(call test_number,$(n))))

# With MINUTES soak.sh builds each test anew, with other random numbers.
soak: $(if $(MINUTES),,$(TESTS:%=$(BUILD)/test_%)) firsts all
	$(if $(MINUTES),,$(Q)$(MAKE) --no-print-directory pages FULL=1)
	@$(if $(MINUTES),MINUTES=$(MINUTES)) CC="$(CC)" BUILD="$(BUILD)" REAL="$(REAL)" JOBS="$(JOBS)" CHECK_SOAK=1 \
	  sh tests/$(if $(MINUTES),soak.sh,run.sh $(TESTS))

# FULL=1: of what the programs print with --full, but for BRIEF=".." of them; KEEP=FOLDER, a whole path: keeps it there, and their CSV.
# BENCH_ONCE: times, which nobody compares, are taken once.
pages: all $(if $(FULL),$(if $(filter 27_effects,$(BRIEF)),,$(BUILD)/27_tax))
	@BENCH_ONCE=1 BUILD="$(BUILD)" REAL="$(REAL)" JOBS="$(JOBS)" FULL="$(FULL)" BRIEF="$(BRIEF)" KEEP="$(KEEP)" sh tests/pages.sh

precision:
	$(Q)$(MAKE) --no-print-directory $(J) BUILD=$(BUILD)/double REAL=double all
	$(Q)$(MAKE) --no-print-directory $(J) BUILD=$(BUILD)/float REAL=float all
	@BUILD="$(BUILD)" sh tests/precision.sh $(CHAPTERS)

graph:
	@sh tests/rules.sh graph

# In double and in float; no part of `make test`. Exit 1: a wrong answer where none is promised.
$(BUILD)/hard_cases: tests/hard/cases.c $(STAMP)
	$(if $(V),,@echo "CC tests/hard/cases")
	$(Q)$(CC) $(ALL_CFLAGS) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)
hard-cases:
	$(Q)$(MAKE) --no-print-directory $(J) BUILD=$(BUILD)/double REAL=double $(BUILD)/double/hard_cases
	$(Q)$(MAKE) --no-print-directory $(J) BUILD=$(BUILD)/float REAL=float $(BUILD)/float/hard_cases
	@$(BUILD)/double/hard_cases; a=$$?; echo; $(BUILD)/float/hard_cases && [ $$a -eq 0 ]

# Each program's main table as CSV, for costs and notes. In 17 and 27 it holds no error. For notes some print all
# their tables, as the ledger has numbers of these, and times, of which it has none, are taken once.
TABLED := $(filter-out 17_compare 27_effects,$(CHAPTERS))
csv:
	$(Q)$(MAKE) --no-print-directory $(J) all
	@mkdir -p $(BUILD)/csv && ln -sfn "$(CURDIR)/chapters" $(BUILD)/csv/chapters
	@for c in $(TABLED); do case " $(WHOLE) " in *" $$c "*) full=--full ;; *) full= ;; esac; \
	  echo "$$c $$full --csv"; \
	  (cd $(BUILD)/csv && "$(abspath $(BUILD))/$$c" $$full --csv $$c.csv >$$c.out) || exit 1; done
$(BUILD)/costs: tests/costs/costs.c $(STAMP)
	$(if $(V),,@echo "CC tests/costs/costs")
	$(Q)$(CC) $(ALL_CFLAGS) -MMD -MP -MF $@.d -MT $@ -o $@ $< $(LDLIBS)
costs: $(BUILD)/costs csv
	$(Q)$(BUILD)/costs $(BUILD)/csv

mutants:
	@FILES="$(FILES)" SEED="$(SEED)" N="$(N)" EDIT="$(EDIT)" CC="$(CC)" sh tests/mutants.sh

.PHONY: commands compilers coverage
commands:
	@sh tests/commands.sh
compilers:
	@FILES="$(FILES)" JOBS=$(JOBS) sh tests/compilers.sh
coverage: all firsts
	@BUILD="$(BUILD)" TESTS="$(if $(filter command line,$(origin TESTS)),$(TESTS))" sh tests/coverage.sh

# The only targets with a program or a library of others, book and embree, are never part of what the rest builds.
book:
	@sh tests/book.sh $(BUILD)

notes:
	@BENCH_ONCE=1 $(MAKE) --no-print-directory csv WHOLE="08_object_order 09_aabb 12_kdtree 18_shade 22_radiometry"
	@sh tests/notes.sh table $(BUILD)/csv

# Called by tests/mine.sh again, with MINE a whole path.
mine-%: FORCE
	@MAKE="$(MAKE)" CC="$(CC)" BUILD="$(BUILD)" sh tests/mine.sh "$*" "$(MINE)" $(if $(FULL),--full)

bugs:
	@sh tests/bugs.sh list
bug-%-answer: FORCE
	@sh tests/bugs.sh answer "$*"
bug-%: FORCE
	@CC="$(CC)" BUILD="$(BUILD)" sh tests/bugs.sh $(if $(TEST),try,show) "$*" $(if $(TEST),"$(TEST)")

# Homework: tests/assignments/README.md, chapters/teaching.md. A folder that is there already is left alone.
ASSIGNMENTS := $(notdir $(wildcard tests/assignments/[0-9][0-9]))
SET ?= $(ASSIGNMENTS)
assignment:
	@for n in $(SET); do \
	  if [ -e $(BUILD)/assignment-$$n ]; then echo "$(BUILD)/assignment-$$n is there already: left alone"; \
	  else $(MAKE) --no-print-directory assignment-$$n || exit 1; fi; done
$(ASSIGNMENTS:%=assignment-%): assignment-%:
	@mkdir -p $(BUILD)
	@CC="$(CC)" sh tests/assignments/write.sh $* $(BUILD)/assignment-$*
grade:
	@CC="$(CC)" BUILD="$(BUILD)" CLASS=$(if $(SUBMISSIONS),yes,no) \
	  sh tests/assignments/grade.sh $(if $(SUBMISSIONS),"$(SUBMISSIONS)",$(if $(SUBMISSION),"$(SUBMISSION)"))
.PHONY: assignment grade $(ASSIGNMENTS:%=assignment-%)

embree: $(STAMP)
	@echo '#include <embree3/rtcore.h>' | $(CC) -fsyntax-only -x c - 2>/dev/null || \
	  { echo "embree: embree3/rtcore.h is missing: install Embree 3 (Debian: libembree-dev)" >&2; exit 2; }
	$(Q)$(CC) $(ALL_CFLAGS) -o $(BUILD)/embree chapters/15_wide_bvh/lab/embree.c -lembree3 $(LDLIBS)
	$(Q)$(BUILD)/embree $(if $(MESH),--mesh $(MESH))

# Without null, object-size and pointer-overflow: what they find AddressSanitizer stops too, where memory is touched;
# the compiler is done sooner; so it is without warnings, which other builds show, and with -g1, which knows lines only.
sanitize:
	$(Q)CHECK_DIVISOR=10 $(MAKE) --no-print-directory BUILD=$(BUILD)/sanitize MUCH_CFLAGS=-O1 WARN= WARN_FIRST= test \
	  CFLAGS="-O0 -g1 -fsanitize=address,undefined -fno-sanitize=null,object-size,pointer-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer"

# One file that does not compile, or one finding, and make fails. Warnings of system headers are only counted.
TIDY ?= $(wildcard chapters/*/main.c chapters/*/first.c tests/*.c)
tidy:
	@command -v clang-tidy >/dev/null || \
	  { echo "tidy: clang-tidy is missing: install it (Debian: clang-tidy)" >&2; exit 2; }
	@printf '%s\n' $(TIDY) | xargs -P $(JOBS) -I FILE clang-tidy --quiet FILE -- -std=c11 -DREAL=$(REAL) \
	  '-DBUILD_FLAGS=""' 2>/dev/null || { echo "tidy: findings, see above" >&2; exit 1; }
	@echo "tidy: no findings in $(words $(TIDY)) files and what they include"

# Without -march=native: valgrind knows no AVX-512. A two-hundredth of the counts: it is some fifty times slower.
.PHONY: valgrind
VALGRIND = $(if $(filter command line,$(origin TESTS)),$(TESTS),07_mesh 13_painter 14_build 14_bvh vec3)
valgrind:
	$(Q)$(MAKE) --no-print-directory $(J) BUILD=$(BUILD)/valgrind CFLAGS=-O1 $(VALGRIND:%=$(BUILD)/valgrind/test_%)
	@for t in $(VALGRIND); do CHECK_DIVISOR=200 valgrind -q --error-exitcode=9 --leak-check=full \
	  --errors-for-leak-kinds=definite $(BUILD)/valgrind/test_$$t || exit 1; done

clean:
	rm -rf $(BUILD)

help:
	@sed -n '/^#/!q; s/^# \{0,1\}//p' Makefile
