# make          builds and runs the public tests          make test-3    only those of exercise 3
# make alone    does each file compile beside the others as they were?  It is graded so
# make picture  the chapter's picture, drawn by your functions: picture.png
# make clean    removes what was built
CC ?= cc
CFLAGS ?= -std=c11 -O1 -g -Wall -Wextra -Wno-unused-parameter -Wno-unused-function
EXACT = -ffp-contract=off
FILES := $(wildcard [0-9]_*.h)
NUMBERS := $(foreach f,$(FILES),$(firstword $(subst _, ,$(f))))

# Each exercise is a process of its own: if one crashes, the others are still tested.
test: alone build/test
	@for n in $(NUMBERS); do build/test $$n || echo "       (exercise $$n ended with status $$?)"; done
$(NUMBERS:%=test-%): test-%: build/test
	@build/test $*
build/test: $(FILES) $(wildcard tests/*)
	@mkdir -p build
	$(CC) $(CFLAGS) $(EXACT) -iquote . -iquote tests -iquote book -o $@ tests/test.c -lm

alone:
	@for f in $(FILES); do rm -rf build/alone; mkdir -p build/alone; cp $$f build/alone/; \
	  $(CC) -std=c11 -w -fsyntax-only -iquote build/alone -iquote tests/stubs -iquote tests -iquote book \
	    tests/test.c || echo "$$f does not compile alone"; done

picture: $(FILES)
	@mkdir -p build
	$(CC) $(CFLAGS) $(EXACT) -iquote . -o build/picture book/chapters/@NAME@/first.c -lm
	build/picture picture.png

clean:
	rm -rf build
.PHONY: test alone picture clean $(NUMBERS:%=test-%)
