"""Each tidy check complains about a tree that breaks its rule, and about nothing in one that keeps
it."""
import pathlib
import tempfile
import unittest

import claims
import documents
import formatting
import includes
import text
import walks

CONTRACT = "#pragma once\n// What it is, in one sentence.\n"


def breaches(check, files):
    """What the check says about a tree of {path: text}."""
    with tempfile.TemporaryDirectory() as root:
        for path, content in files.items():
            file = pathlib.Path(root) / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(content, encoding="utf-8")
        return list(check(root))


def include(name):
    return f'#include "{name}"\n'


class Levels(unittest.TestCase):
    def expect(self, includer, included, expected):
        files = {included: CONTRACT}
        files[includer] = include(included)
        found = breaches(includes.check_levels, files)
        self.assertEqual(len(found), expected, f"{includer} → {included}: {found}")

    def test_an_arrow_to_a_lower_level_is_allowed(self):
        self.expect("common/world/a.cpp", "common/base/b.h", 0)
        self.expect("common/evaluation/a.cpp", "common/world/strategies/b.h", 0)
        self.expect("learner/a.cpp", "common/nn/b.h", 0)
        self.expect("deploy/a.cpp", "common/dds/b.h", 0)
        self.expect("tests/unit/a.cpp", "learner/b.h", 0)

    def test_an_arrow_upwards_or_sideways_is_a_breach(self):
        self.expect("common/base/a.h", "common/world/b.h", 1)
        self.expect("common/world/a.cpp", "common/rl/b.h", 1)
        self.expect("common/policies/a.cpp", "common/environments/b.h", 1)
        self.expect("common/dds/a.cpp", "actor/b.h", 1)
        self.expect("common/evaluation/a.cpp", "common/dds/b.h", 1)

    def test_level_2_libraries_never_include_each_other_or_dds(self):
        self.expect("actor/a.cpp", "learner/b.h", 1)
        self.expect("replay/a.cpp", "common/nn/b.h", 1)
        self.expect("learner/a.cpp", "common/dds/b.h", 1)

    def test_a_main_may_include_dds_and_run_and_a_config_may_include_run(self):
        self.expect("actor/main.cpp", "common/dds/b.h", 0)
        self.expect("actor/main.cpp", "replay/b.h", 1)
        self.expect("actor/actor_config.h", "common/run/b.h", 0)
        self.expect("actor/actor.h", "common/run/b.h", 1)

    def test_only_tests_and_benchmarks_include_tests(self):
        self.expect("bench/a.cpp", "tests/b.h", 0)
        self.expect("deploy/a.cpp", "tests/b.h", 1)
        self.expect("actor/a.cpp", "tests/b.h", 1)

    def test_a_file_must_exist_and_be_named_from_the_root(self):
        files = {"common/base/a.cpp": include("b.h"), "common/base/b.h": CONTRACT}
        self.assertEqual(len(breaches(includes.check_levels, files)), 1)

    def test_a_folder_that_the_rule_does_not_know_is_a_breach(self):
        self.assertEqual(len(breaches(includes.check_levels, {"common/new/a.h": CONTRACT})), 1)
        self.assertEqual(len(breaches(includes.check_levels, {"loose.cpp": ""})), 1)


class Middleware(unittest.TestCase):
    FAST_DDS = "#include <fastdds/dds/topic/Topic.hpp>\n"

    def test_fast_dds_belongs_under_common_dds(self):
        found = breaches(includes.check_middleware, {"actor/main.cpp": self.FAST_DDS,
                                                     "common/dds/a.cpp": self.FAST_DDS})
        self.assertEqual(len(found), 1)
        self.assertIn("actor/main.cpp:1", found[0])

    def test_generated_headers_belong_under_common_dds(self):
        found = breaches(includes.check_middleware, {
            "idl/weights.idl": "", "actor/a.cpp": "#include <weightsPubSubTypes.h>\n",
            "actor/b.cpp": "#include <weights.h>\n", "actor/c.cpp": "#include <weight.h>\n"})
        self.assertEqual(len(found), 2)

    def test_a_header_that_others_include_shows_none_of_it_even_by_way_of_another(self):
        files = {"common/dds/private.h": self.FAST_DDS,
                 "common/dds/shown.h": include("common/dds/private.h"),
                 "actor/main.cpp": include("common/dds/shown.h")}
        found = breaches(includes.check_middleware, files)
        self.assertEqual(len(found), 1)
        self.assertIn("common/dds/private.h:1", found[0])
        del files["actor/main.cpp"]
        self.assertEqual(breaches(includes.check_middleware, files), [])


class Libraries(unittest.TestCase):
    def test_cereal_is_in_sources_and_archive_headers(self):
        cereal = "#include <cereal/types/vector.hpp>\n"
        found = breaches(includes.check_libraries, {"a/b.cpp": cereal, "a/b_archive.h": cereal,
                                                    "a/b.h": cereal})
        self.assertEqual(len(found), 1)
        self.assertIn("a/b.h:1", found[0])

    def test_toml_is_in_sources_of_run_and_of_configs(self):
        toml = "#include <toml++/toml.h>\n"
        found = breaches(includes.check_libraries, {
            "common/run/a.cpp": toml, "actor/actor_config.cpp": toml,
            "common/run/a.h": toml, "actor/actor.cpp": toml})
        self.assertEqual(len(found), 2)


class Text(unittest.TestCase):
    def test_a_header_opens_with_its_contract(self):
        check = text.check_contracts
        self.assertEqual(breaches(check, {"a.h": CONTRACT}), [])
        for bad in ("", "// First.\n#pragma once\n", "#pragma once\n", "#pragma once\n\n// Late.\n",
                    "#pragma once\n//\n", "#pragma once\n#include <a>\n"):
            self.assertEqual(len(breaches(check, {"a.h": bad})), 1, repr(bad))

    def test_columns_are_counted_in_characters(self):
        self.assertEqual(breaches(text.check_columns, {"a.cpp": "é" * 100}), [])
        self.assertEqual(breaches(text.check_columns, {"a.cpp": "m\u0302" * 100}), [])
        self.assertEqual(len(breaches(text.check_columns, {"a.cpp": "é" * 101})), 1)

    def test_sizes(self):
        files = {"a.h": "\n" * 200, "a.cpp": "\n" * 450}
        self.assertEqual(breaches(text.check_sizes, files), [])
        files = {"a.h": "\n" * 201, "a.cpp": "\n" * 451}
        self.assertEqual(len(breaches(text.check_sizes, files)), 2)

    def test_a_function_has_80_lines_at_most(self):
        function = "int F(int a,\n      int b) {\n%s}\n\nstruct S {\n};\n"
        check = text.check_sizes
        self.assertEqual(breaches(check, {"a.cpp": function % ("  f();\n" * 77)}), [])
        found = breaches(check, {"a.cpp": function % ("  f();\n" * 78)})
        self.assertEqual(len(found), 1)
        self.assertIn("a.cpp:1", found[0])
        self.assertEqual(breaches(check, {"a_reference.h": function % ("  f();\n" * 78)}), [])

    def test_names(self):
        files = {"run_manager.h": "", "handler_list.cpp": "", "utils.py": "", "manage.h": "",
                 "BigName.cpp": "", "a/Big/b.h": "", "two-words.sh": "", "CMakeLists.txt": "",
                 "cmake/FindGLPK.cmake": "", "FindGLPK.h": ""}
        self.assertEqual(len(breaches(text.check_names, files)), 7)

    def test_code_in_comments_and_open_points_are_breaches(self):
        check = text.check_comments
        for line in ("  // f(a, b);", "// x = 3;", "//x += y * 2;", "  // if (a) {", "// i++;",
                     "// return x;", "// a.b->c();", "int x;  // TODO: more"):
            self.assertEqual(len(breaches(check, {"a.cpp": line})), 1, line)
        for line in ("// O = 3 V: distances, ascending;", "// the neighbour (lowest index);",
                     "//   world.Reset(starts, rng);", "// if not, the last one stands;",
                     'Print("TODOS");'):
            self.assertEqual(breaches(check, {"a.cpp": line}), [], line)

    def test_a_test_that_sleeps_is_a_breach(self):
        check = text.check_sleeps
        for path, line in (("tests/a.cpp", "std::this_thread::sleep_for(ms(1));"),
                           ("tests/a.cpp", "usleep(5);"), ("tests/a.h", "sleep(1);"),
                           ("tests/a.py", "time.sleep(1)"), ("tests/a.sh", "make; sleep 1"),
                           ("tests/a.sh", "while true; do sleep 0.1; done")):
            self.assertEqual(len(breaches(check, {path: line})), 1, line)
        for path, line in (("common/a.cpp", "usleep(5);"), ("tests/a.cpp", "f();  // sleep(1)"),
                           ("tests/a.cpp", "Asleep(1);"), ("tests/a.sh", "# sleep 1")):
            self.assertEqual(breaches(check, {path: line}), [], line)


class Claims(unittest.TestCase):
    GOOD = 'TEST_CASE("A sum is "\n          "a sum") {\n  CHECK(1 + 1 == 2);\n}\n'
    CMAKE = "ronda_test(a SOURCES a_test.cpp)\n"

    def check(self, path, content, cmake=CMAKE):
        return breaches(claims.check_tests, {path: content, "CMakeLists.txt": cmake})

    def test_a_test_that_is_built_and_checks_something_is_good(self):
        self.assertEqual(self.check("tests/a_test.cpp", self.GOOD), [])
        by_helper = self.GOOD.replace("CHECK(", "CheckIt<int>(")
        self.assertEqual(self.check("tests/a_test.cpp", by_helper), [])

    def test_a_test_that_cannot_fail_or_is_not_built_is_a_breach(self):
        cannot_fail = self.GOOD.replace("CHECK", "Do") + self.GOOD
        self.assertEqual(len(self.check("tests/a_test.cpp", cannot_fail)), 1)
        self.assertEqual(len(self.check("tests/a_test.cpp", self.GOOD, "")), 1)
        self.assertEqual(len(self.check("tests/a_test.cpp", self.GOOD, "b_a_test.cpp")), 1)
        self.assertEqual(len(self.check("tests/a_test.cpp", "")), 1)

    def test_a_name_that_claims_nothing_is_a_breach(self):
        short = 'TEST_CASE("sums") {\n  CHECK(1 + 1 == 2);\n}\n'
        self.assertEqual(len(self.check("tests/a_test.cpp", short)), 1)
        self.assertEqual(len(self.check("tests/a.cpp", self.GOOD)), 1)


class Documents(unittest.TestCase):
    def links(self, line):
        return breaches(documents.check_links, {"docs/a.md": f"# Two words\n{line}\n",
                                                "docs/b.md": "# It's: 1\n", "common/x/y.h": ""})

    def test_links_that_lead_somewhere_are_good(self):
        for line in ("[b](b.md)", "[b](b.md#its-1)", "[a](#two-words)", "[x](../common/x/y.h)",
                     "[web](https://example.org/none)", "`common/x/y.h`", "`common/x/y`",
                     "`common/x/*.h`", "`[not](a-link)`", "```\n[not](a-link)\n```"):
            self.assertEqual(self.links(line), [], line)

    def test_a_link_or_path_to_nowhere_is_a_breach(self):
        for line in ("[c](c.md)", "[b](b.md#its-2)", "[a](#three)", "`common/x/z.h`", "`docs/c`"):
            self.assertEqual(len(self.links(line)), 1, line)

    def test_decisions_are_numbered_once_and_titled(self):
        check = documents.check_decisions
        good = {"docs/adr/0001-a-title.md": "# 1. A title\n", "docs/adr/0012-b.md": "# 12. B\n"}
        self.assertEqual(breaches(check, good), [])
        for path, content in (("0001-again.md", "# 1. Again\n"), ("0003-c.md", "# 4. C\n"),
                              ("0003-c.md", "# C\n"), ("0003-c.md", ""), ("3-c.md", "# 3. C\n"),
                              ("0003-Title.md", "# 3. Title\n")):
            found = breaches(check, {**good, f"docs/adr/{path}": content})
            self.assertEqual(len(found), 1, path)


class Walks(unittest.TestCase):
    GOOD = ("## One transition\n\nIn words:\n\n" + "1. `a/b.cpp`: a stop\n" * 8 +
            "\n## One weight update\n" + "- `a/b.cpp`: a stop, `not_a_path`\n" * 5 +
            "\n## More\n- x\n")

    def walk(self, document):
        return breaches(walks.check_walks, {"ARCHITECTURE.md": document, "a/b.cpp": ""})

    def test_walks_whose_files_exist_are_good(self):
        self.assertEqual(self.walk(self.GOOD), [])

    def test_a_missing_document_section_stop_or_file_is_a_breach(self):
        self.assertEqual(len(breaches(walks.check_walks, {})), 1)
        self.assertEqual(len(self.walk(self.GOOD.replace("One transition", "Another"))), 1)
        self.assertEqual(len(self.walk(self.GOOD.replace("1. `a/b.cpp`: a stop\n", "", 1))), 1)
        self.assertEqual(len(self.walk(self.GOOD.replace("`a/b.cpp`", "`a/c.cpp`", 1))), 1)
        self.assertEqual(len(self.walk(self.GOOD.replace("`a/b.cpp`", "a/b.cpp", 1))), 1)


@unittest.skipIf(formatting.missing_tool(), "no clang-format 14 here")
class Formatting(unittest.TestCase):
    def test_what_clang_format_would_change_is_a_breach(self):
        style = {".clang-format": "BasedOnStyle: Google\n"}
        check = formatting.check_formatting
        self.assertEqual(breaches(check, {**style, "a.cpp": "int a = 1;\n"}), [])
        found = breaches(check, {**style, "a.cpp": "int a = 1;\n", "b.cpp": "int  b;\n"})
        self.assertEqual(len(found), 1)
        self.assertIn("b.cpp:1", found[0])


if __name__ == "__main__":
    unittest.main()
