use numerics::random::mixed;

/// As the published program gives them for the key 1234567.
#[test]
fn mixed_numbers_are_those_of_the_sequence() {
    let expected = [
        6_457_827_717_110_365_317,
        3_203_168_211_198_807_973,
        9_817_491_932_198_370_423,
    ];
    assert_eq!([1, 2, 3].map(|place| mixed(1_234_567, place)), expected);
}
