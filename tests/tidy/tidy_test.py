"""Each tidy check complains about a tree that breaks its rule, and about nothing in one that keeps
it."""
import pathlib
import tempfile
import unittest

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

    def test_names(self):
        files = {"run_manager.h": "", "HandlerList.cpp": "", "utils.py": "", "manage.h": ""}
        self.assertEqual(len(breaches(text.check_names, files)), 3)

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
