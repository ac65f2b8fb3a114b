use super::{MAX_EXPRESSION, MAX_EXPRESSION_DEPTH, Mistake, Offsets, PartKind, parse};

/// An expression with all its brackets, or the mistake with its place.
fn shown(text: &str) -> String {
    match parse(text) {
        Ok(parts) => {
            let mut texts: Vec<String> = Vec::new();
            for part in &parts {
                let of = |at: &usize| texts[*at].clone();
                let shown = match &part.kind {
                    PartKind::Number(number) => number.clone(),
                    PartKind::Boolean(truth) => truth.to_string(),
                    PartKind::Text(text) => format!("'{text}'"),
                    PartKind::Name(name) => name.clone(),
                    PartKind::Member(whole, name) => format!("{}.{name}", of(whole)),
                    PartKind::Element(whole, index) => format!("{}[{index}]", of(whole)),
                    PartKind::Operation(operator, parts) => match parts.as_slice() {
                        [one] => format!("({}{})", operator.sign(), of(one)),
                        [one, other] => format!("({} {} {})", of(one), operator.sign(), of(other)),
                        _ => unreachable!("one or two operands"),
                    },
                    PartKind::Choice(a, b, c) => format!("({} ? {} : {})", of(a), of(b), of(c)),
                    PartKind::Call(name, arguments) => {
                        let given: Vec<String> = arguments
                            .iter()
                            .map(|it| match &it.name {
                                Some((name, _)) => format!("{name}: {}", of(&it.value)),
                                None => of(&it.value),
                            })
                            .collect();
                        format!("{name}({})", given.join(", "))
                    }
                };
                assert!(part.mark.start >= part.span.start && part.mark.end <= part.span.end);
                texts.push(shown);
            }
            texts.pop().unwrap()
        }
        Err(mistakes) => {
            let told = mistakes.iter().map(|Mistake { span, message, help, .. }| {
                assert!(span.end <= text.len() && text.get(span.clone()).is_some(), "{text}");
                format!("{}..{} {message}; {help}", span.start, span.end)
            });
            told.collect::<Vec<String>>().join("\n")
        }
    }
}

#[test]
fn operators_bind_as_the_table_says() {
    for (text, expected) in [
        ("1 + 2 * 3 - 4", "((1 + (2 * 3)) - 4)"),
        ("a - b - c", "((a - b) - c)"),
        ("a / b * c % d", "(((a / b) * c) % d)"),
        ("2 ** 3 ** 2", "(2 ** (3 ** 2))"),
        ("-x ** 2", "(-(x ** 2))"),
        ("-x * y", "((-x) * y)"),
        ("2 ** -1", "(2 ** -1)"),
        ("2 ** -x", "(2 ** (-x))"),
        ("--2", "(--2)"),
        ("a < b && c >= d || !e", "(((a < b) && (c >= d)) || (!e))"),
        ("not a < b and c", "((!(a < b)) && c)"),
        ("a or b and c", "(a || (b && c))"),
        ("a ? b : c ? d : e", "(a ? b : (c ? d : e))"),
        ("a ? b ? c : d : e", "(a ? (b ? c : d) : e)"),
        ("a + 1 > 0 ? b : c + 1", "(((a + 1) > 0) ? b : (c + 1))"),
        ("(a + b).x", "(a + b).x"),
        (
            "layers[2].tint.rgb * f(x, low: 0, high: g())",
            "(layers[2].tint.rgb * f(x, low: 0, high: g()))",
        ),
        ("f(a ? b : c)", "f((a ? b : c))"),
        (".5 + 5. + 1e-3 + 2.50", "(((0.5 + 5) + 1e-3) + 2.50)"),
        ("kind == 'a b'", "(kind == 'a b')"),
        ("größe*2", "(größe * 2)"),
        ("true != false", "(true != false)"),
    ] {
        assert_eq!(shown(text), expected, "{text}");
    }
}

#[test]
fn mistakes_have_a_place_and_a_remedy() {
    for (text, expected) in [
        ("", "0..0 the expression is empty; write a value, such as `0.5 * (noise + 1)`"),
        (
            "1 +",
            "2..3 expected a value, found the end of the expression; a value is a number, a name, a function or `( … )`",
        ),
        ("(1 + 2", "0..1 this `(` is never closed; add a `)`"),
        ("f(1, 2", "1..2 this `(` is never closed; add a `)`"),
        ("1 + 2)", "5..6 this `)` closes nothing; remove it, or add a `(`"),
        (
            "a b",
            "2..3 expected an operator, found `b`; put an operator such as `*` between the two values",
        ),
        ("2x", "0..2 `2x` is neither a number nor a name; write `2 * x` for a product"),
        ("1.0f", "0..4 `1.0f` is neither a number nor a name; write `1.0`"),
        ("a = b", "2..3 `=` assigns nothing here; write `==`"),
        ("a ^ 2", "2..3 `^` is a power to some and \"exclusive or\" to others; write `**`"),
        ("a & b", "2..3 there is no operator `&`; write `&&`"),
        ("a <> b", "2..4 there is no operator `<>`; write `!=`"),
        ("a < b < c", "6..7 `<` and `<` cannot be chained; join two comparisons: `a < b && b < c`"),
        (
            "a ? b",
            "4..5 expected `:` and the other value, found the end of the expression; write `condition ? one : other`",
        ),
        ("a : b", "2..3 this `:` has no `?`; write `condition ? one : other`"),
        ("f(a,)", "3..4 an argument is missing behind this `,`; remove it"),
        ("f(a b)", "4..5 expected `,` or `)`, found `b`; arguments are parted by `,`"),
        (
            "a, b",
            "1..2 an expression is one value; write `vector(x, y, z)` or `color(r, g, b)` for several numbers",
        ),
        (
            "[1, 2, 3]",
            "0..1 there are no lists in an expression; write `vector(x, y, z)` or `color(r, g, b)`",
        ),
        (
            "a[i]",
            "2..3 expected a whole number, found `i`; an index is known before shading; an `element` node chooses by a computed one",
        ),
        (
            "a.",
            "1..2 expected a name behind `.`, found the end of the expression; such as `.x`, `.rgb` or the name of an output",
        ),
        (
            "+a",
            "0..1 a `+` before a value does nothing; remove it: a value without a sign is the same",
        ),
        ("'abc", "0..1 this text has no closing quote; add `'` behind it"),
        ("a;", "1..2 an expression is one value, and ends without `;`; remove it"),
        ("007", "0..3 the number `007` begins with 0; write it without the leading zeros"),
        ("$a", "0..1 names are written without `$`; remove it"),
        ("\u{1F600}", "0..4 the character '😀' has no meaning in an expression; remove it"),
    ] {
        assert_eq!(shown(text), expected, "{text}");
    }
}

#[test]
fn several_mistakes_are_told_at_once_and_nothing_that_follows_from_them() {
    /// Where the mistakes are, each with its first words.
    fn places(text: &str) -> Vec<String> {
        let Err(mistakes) = parse(text) else { return Vec::new() };
        let told = mistakes.iter().map(|it| {
            let words: Vec<&str> = it.message.split(' ').take(3).collect();
            format!("{}..{} {}", it.span.start, it.span.end, words.join(" "))
        });
        told.collect()
    }
    for (text, expected) in [
        (
            "(1 + ) * f(2,, 3) & 4",
            &["5..6 expected a value,", "13..14 expected a value,", "18..19 there is no"][..],
        ),
        (
            "a ^ 2 = b + 2x",
            &["2..3 `^` is a", "6..7 `=` assigns nothing", "12..14 `2x` is neither"],
        ),
        ("a if b else c", &["2..4 expected an operator,"]),
        ("1 + * 2 - / 3", &["4..5 expected a value,", "10..11 expected a value,"]),
        (
            "f(a b c, 2x, $d)",
            &["4..5 expected `,` or", "9..11 `2x` is neither", "13..14 names are written"],
        ),
        ("a ; b ; c", &["2..3 an expression is", "6..7 an expression is"]),
        ("{a + b}", &["0..1 `{` has no", "6..7 `}` has no"]),
        ("a)) * 2 ^ b", &["1..2 this `)` closes", "8..9 `^` is a"]),
        ("a, b, c", &["1..2 an expression is"]),
        ("(a, b, c).rgb * 007", &["2..3 an expression is", "16..19 the number `007`"]),
        (
            "[1, [2], 3] * (a + ",
            &["0..1 there are no", "17..18 expected a value,", "14..15 this `(` is"],
        ),
        ("f(g(h(1 + 2", &["5..6 this `(` is"]),
        ("a < b < c < d", &["6..7 `<` and `<`"]),
        ("(a < b) == (c < d)", &[]),
        ("a[i] + b[2", &["2..3 expected a whole", "9..10 expected `]`, found"]),
        ("a. + b.1", &["3..4 expected a name", "6..8 expected an operator,"]),
        ("a ? b, c", &["5..6 expected `:` and"]),
        ("f(a ? b) + +c", &["7..8 expected `:` and", "11..12 a `+` before"]),
        ("'abc + (", &["0..1 this text has"]),
        ("and + (or)", &["0..3 expected a value,", "7..9 expected a value,"]),
        ("\u{1F600}\u{1F600}\u{1F600} + a", &["0..4 the character '\u{1F600}'"]),
    ] {
        assert_eq!(places(text), expected, "{text}");
    }
    assert_eq!(places(&"a ^".repeat(100)).len(), 10, "there is an end to it");
}

#[test]
fn no_text_makes_the_parser_stop_or_fall() {
    let words = [
        "(",
        ")",
        "[",
        "]",
        ",",
        ":",
        "?",
        ".",
        "a",
        "f(",
        "1",
        "'",
        "-",
        "!",
        "not ",
        "and ",
        "<",
        "==",
        "**",
        "^",
        "=",
        ";",
        "\u{e9}",
        "\u{1F600}",
        "2x",
        "1e999",
        " ",
        "\"",
        "+",
        "*",
    ];
    let mut state: u32 = 1;
    for length in (1..=24).cycle().take(20_000) {
        let mut text = String::new();
        for _ in 0..length {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            text.push_str(words[(state >> 16) as usize % words.len()]);
        }
        match parse(&text) {
            Ok(parts) => assert!(!parts.is_empty(), "{text}"),
            Err(mistakes) => {
                // Ten, and a bracket that is never closed.
                assert!((1..=11).contains(&mistakes.len()), "{text}");
                for mistake in mistakes {
                    assert!(text.get(mistake.span).is_some(), "{text}");
                }
            }
        }
    }
}

#[test]
fn what_is_too_deep_or_too_long_is_refused_and_never_overflows() {
    let nested = |depth: usize| format!("{}1{}", "(".repeat(depth), ")".repeat(depth));
    assert_eq!(shown(&nested(MAX_EXPRESSION_DEPTH - 1)), "1");
    assert!(shown(&nested(MAX_EXPRESSION_DEPTH)).contains("nested more than"));
    for open in ["(", "-", "!", "1**", "a?b:", "a?", "f(", "not "] {
        let text = open.repeat(MAX_EXPRESSION / open.len());
        assert!(shown(&text).contains("nested more than"), "{open}");
        assert!(shown(&open.repeat(1_000_000)).contains("at most"), "{open}");
    }
    let long = format!("1{}", "+1".repeat((MAX_EXPRESSION - 1) / 2));
    assert!(parse(&long).is_ok(), "a sum is no nesting");
}

#[test]
fn characters_are_found_behind_escapes() {
    let text = r#"  "a\"é\u00e9\ud83d\ude00\n😀b" "#;
    let decoded = "a\"éé😀\n😀b";
    let offsets = Offsets::of(text, 2, text.len() - 1);
    let place = |of: &str| {
        let start = decoded.rfind(of).unwrap();
        offsets.place(&(start..start + of.len()))
    };
    let told = |(start, end): (usize, usize)| &text[start..end];
    assert_eq!(told(place("a")), "a");
    assert_eq!(told(place("\"")), "\\\"");
    assert_eq!(told(place("é")), "\\u00e9");
    assert_eq!(told(place("\n")), "\\n");
    assert_eq!(told(place("😀b")), "😀b");
    assert_eq!(told(offsets.place(&(6..10))), "\\ud83d\\ude00");
    assert_eq!(told(offsets.place(&(100..200))), "");
}
