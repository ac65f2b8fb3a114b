//! What is said of broken expressions: at the right characters, in words of the file, and no more than is wrong.

use crate::build::told;

/// A file with an inner phenomenon, a map and a fold, each with room for an expression.
fn file(inner: &str, node: &str, turn: &str, root: &str) -> String {
    let of = |text: &str| match text.strip_prefix('{') {
        Some(rest) => format!("{{{rest}"),
        None => format!("{{ \"expression\": \"{text}\" }}"),
    };
    let (inner, node, turn, root) = (of(inner), of(node), of(turn), of(root));
    format!(
        r#"{{ "phenomenon": "g", "interface": {{ "amount": {{ "type": "scalar", "default": 0.5 }}, "tint": {{ "type": "color", "default": 1 }} }},
        "phenomena": {{
            "p": {{ "interface": {{ "x": {{ "type": "scalar", "default": 1 }} }}, "outputs": {{ "y": {{ "type": "scalar", "from": {inner} }} }} }},
            "turn": {{ "interface": {{ "item": {{ "type": "scalar", "default": 0 }}, "k": {{ "type": "scalar", "default": 9 }} }},
                "outputs": {{ "y": {{ "type": "scalar", "from": {{ "expression": "item * k" }} }} }} }} }},
        "nodes": {{ "n": {{ "type": {{ "phenomenon": "p" }}, "inputs": {{ "x": {node} }} }},
            "all": {{ "type": {{ "map": {{ "phenomenon": "turn" }} }}, "inputs": {{ "over": [1, 2, 3], "k": {turn} }} }},
            "s": {{ "type": "sum", "inputs": {{ "values": {{ "node": "all" }} }} }} }},
        "outputs": {{ "o": {{ "type": "color", "from": {{ "expression": "tint * amount" }} }} }},
        "roots": {{ "material": {root} }} }}"#
    )
}

#[test]
fn each_place_is_told_of_once_in_words_of_the_file() {
    let right = ["x + 1", "amount", "amount", "n + s"];
    let with = |at: usize, text: &str| {
        let mut texts = right;
        texts[at] = text;
        told(&file(texts[0], texts[1], texts[2], texts[3]))
    };
    assert_eq!(with(0, "x"), Vec::<String>::new());
    for (at, text, expected) in [
        (0, "x * amount", "unknown-name at amount: nothing here is called `amount`"),
        (
            0,
            "vector(x)",
            "type-mismatch at vector(x): output `y` takes a scalar, but `vector(x)` is a vector",
        ),
        (0, "x +", "expression-syntax at +: expected a value, found the end of the expression"),
        (0, "x * 1e999", "not-finite at 1e999: the number 1e999 is too large for 32 bits"),
        (
            1,
            "tint",
            "type-mismatch at tint: input `x` of node `n` (p) takes a scalar, but parameter `tint` is a color",
        ),
        (1, "n.y", "cycle at n.y: node `n` reads itself"),
        (1, "n + 2 * n", "cycle at n + 2 * n: node `n` reads itself"),
        (
            2,
            "tint * 2",
            "type-mismatch at tint * 2: input `k` of node `all` (turn) takes a scalar, but `tint * 2` is a color",
        ),
        (2, "amuont", "unknown-name at amuont: nothing here is called `amuont`"),
        (2, "s * 2", "cycle at s * 2: 2 nodes read one another in a cycle: `all` → `s` → `all`"),
        (2, "all[0]", "cycle at all[0]: node `all` reads itself"),
        (3, "n + s + all", "type-mismatch at all: the map `all` yields a list of 3, not one value"),
        (
            3,
            "n + s + all.y",
            "type-mismatch at all: the map `all` yields a list of 3, not one value",
        ),
        (
            3,
            "n + s + all[3]",
            "unknown-name at [3]: the map `all` yields a list of 3, which has no [3]",
        ),
        (3, "n + s + all[1].z", "unknown-name at z: node `all` (turn) has no output `z`"),
        (3, "n + s + and", "expression-syntax at and: expected a value, found `and`"),
        (3, "n + s + n.z.w", "unknown-name at z: node `n` (p) has no output `z`"),
        (
            3,
            r#"'\u00e9\"\\' == 'a' ? n : sss"#,
            "unknown-name at sss: nothing here is called `sss`",
        ),
        (3, r"n + \u0073\u0073", r"unknown-name at \u0073\u0073: nothing here is called `ss`"),
        (
            3,
            r"n + s\u0020+\t\u00e9\ud83d\ude00",
            r"expression-syntax at \ud83d\ude00: the character '😀' has no meaning in an expression",
        ),
        (3, "", "expression-syntax at : the expression is empty"),
    ] {
        let told = with(at, text);
        // An expression that is not understood leaves what it names unused.
        let errors: Vec<&String> =
            told.iter().filter(|it| !it.starts_with("un") || it.starts_with("unknown")).collect();
        assert_eq!(errors, [expected], "{text}");
    }
}

#[test]
fn several_mistakes_of_one_text_are_told() {
    let told = told(&file("x ^ (2 * ) + 007", "amount", "f(amount,, $x) = 2x", "n + s"));
    assert_eq!(
        told,
        [
            "expression-syntax at ^: `^` is a power to some and \"exclusive or\" to others",
            "expression-syntax at ): expected a value, found `)`",
            "expression-syntax at 007: the number `007` begins with 0",
            "expression-syntax at ,: expected a value, found `,`",
            "expression-syntax at $: names are written without `$`",
            "expression-syntax at =: `=` assigns nothing here",
            "expression-syntax at 2x: `2x` is neither a number nor a name",
        ]
    );
}

#[test]
fn names_that_no_expression_can_use_are_told() {
    let root = r#"{ "expression": "n + s + a", "where": { "a": 1, "not": 2, "b-c": 3, "2d": 4 } }"#;
    let told = told(&file("x", "amount", "amount", root));
    let bad: Vec<&String> = told.iter().filter(|it| it.starts_with("bad-name")).collect();
    assert_eq!(
        bad,
        [
            "bad-name at \"not\": a name under `where` is `not`, a word of the language",
            "bad-name at \"b-c\": a name under `where` has a `-`, which subtracts in expressions",
            "bad-name at \"2d\": a name under `where` begins with the digit '2'",
        ]
    );
}

#[test]
fn no_finding_has_a_name_that_the_file_does_not_have() {
    let texts = [
        "x",
        "amount",
        "n",
        "s",
        "all",
        "all[1]",
        "-",
        "(",
        "tint",
        "1e999",
        "n.y",
        "sine(",
        "vector(n)",
        "?",
        "\u{e9}",
        "1/0",
        "acos(2)",
    ];
    let mut state: u32 = 7;
    let mut draw = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 16) as usize
    };
    for _ in 0..300 {
        let mut text = || {
            let parts: Vec<&str> =
                (0..1 + draw() % 4).map(|_| texts[draw() % texts.len()]).collect();
            parts.join([" + ", " * ", " ", ", "][draw() % 4])
        };
        let (inner, node, turn, root) = (text(), text(), text(), text());
        for finding in told(&file(&inner, &node, &turn, &root)) {
            let message = finding.split_once(": ").expect("a message").1;
            let names_turn = message.contains("`all[") && !message.contains("has no [");
            let quotes = [&inner, &node, &turn, &root].iter().any(|it| it.contains("all["));
            assert!(
                !message.contains('@') && !message.contains('#') && (!names_turn || quotes),
                "{finding}"
            );
        }
    }
}
