/* SPDX-License-Identifier: BSD-3-Clause
 * Numbers as people write them: what is read, to the last bit, and what is refused. */
#include "support.h"

#include "number.h"

static const struct {
    const char *text;
    double value;
} read[] = {
    {"0", 0.0},
    {"-0", -0.0},
    {"1", 1.0},
    {"+1", 1.0},
    {"0.01", 0.01},
    {"1.", 1.0},
    {".5", 0.5},
    {"-.5e1", -5.0},
    {"1e-3", 1e-3},
    {"1E+3", 1e3},
    {"4.828427124746190", 4.828427124746190},
    {"0.1000000000000000055511151231257827021181583404541015625", 0.1},
    {"1.7976931348623157e308", DBL_MAX},
    {"4.9406564584124654e-324", 0x1p-1074},
    {"0e999", 0.0},
    {"0.000e-999", 0.0},
    {"1/64", 0.015625},
    {"-1/64", -0.015625},
    {"1/-64", -0.015625},
    {"1e-3/2", 0.0005},
    {"0/3", 0.0},
    {"2^-6", 0.015625},
    {"-2^-6", -0.015625}, /* the sign belongs to the whole, as in mathematics */
    {"2^+10", 1024.0},
    {"0^2", 0.0},
    {"4^0.5", 2.0},
    {"2^-1074", 0x1p-1074},
    {" 1 ", 1.0},
    {"\t1 / 64\t", 0.015625},
    {"2 ^ -6", 0.015625},
};

static const char *const refused[] = {
    "",
    " ",
    "+",
    "-",
    ".",
    "e5",
    "1e",
    "1e+",
    "1e5.0",
    "--1",
    "+-1",
    "- 1",
    "1 2",
    "1,5",
    "1_000",
    "1'000",
    "1f",
    "1.0.0",
    "0x10",
    "0x1p-6",
    "1/0",
    "0/0",
    "-1/0",
    "0^-1",
    "1//2",
    "1/",
    "/2",
    "1/2/3",
    "2^",
    "^2",
    "2^3^4",
    "2**3",
    "2^-6/3",
    "1e999",
    "-1e999",
    "2^1e4",
    "2^1024",
    "1e308/1e-308",
    "1e-999",
    "2^-1075",
    "1e-300/1e300",
    "nan",
    "NaN",
    "-nan",
    "inf",
    "-inf",
    "infinity",
    "nan(1)",
    "1/inf",
    "two",
    "~",
    "null",
    "true",
    "1\n",
    "\n1",
    "1 # one",
    "1;",
};

TEST(reads_to_the_bit)
{
    for (size_t k = 0; k < sizeof read / sizeof read[0]; ++k) {
        double value = 12345.0;
        if (number_read(read[k].text, &value) != 0)
            fail_msg("'%s' is refused", read[k].text);
        if (value != read[k].value || signbit(value) != signbit(read[k].value))
            fail_msg("'%s' is read as %.17g, not %.17g", read[k].text, value, read[k].value);
    }
}

TEST(refuses_and_leaves_the_value)
{
    for (size_t k = 0; k < sizeof refused / sizeof refused[0]; ++k) {
        double value = 12345.0;
        if (number_read(refused[k], &value) != -1)
            fail_msg("'%s' is read as %.17g", refused[k], value);
        assert_true(value == 12345.0);
    }
}

/** 17 digits are enough for every double. */
TEST(reads_back_what_printf_writes)
{
    rng g = rng_seed(1);
    for (int k = 0; k < 100000; ++k) {
        const double x = random_finite(&g);
        double value;
        char text[40];
        snprintf(text, sizeof text, "%.17g", x);
        assert_int_equal(number_read(text, &value), 0);
        assert_same_bits(&value, &x, 1);
    }
}

TEST(reads_long_texts)
{
    enum { N = 1000000 };
    char *text = malloc(N + 1);
    double value;
    assert_non_null(text);
    memset(text, '0', N);
    text[N] = '\0';
    text[N - 1] = '7';
    assert_int_equal(number_read(text, &value), 0);
    assert_true(value == 7.0);
    memset(text, '9', N);
    assert_int_equal(number_read(text, &value), -1);
    free(text);
}

/** Any number; one of few digits; one of those that runs are made of, near powers of 2 and 10 too; one that lies
 *  in the middle between two decimals of 17 digits. */
static double number_of_kind(int kind, rng *g)
{
    const double one = 1.0 + (double)(rng_bits(g) >> 12) * 0x1p-52;
    const int power = (int)(rng_bits(g) % 150) - 88;
    switch (kind) {
    case 0:
        return random_finite(g);
    case 1:
        return (double)(rng_bits(g) >> 40) / 1000.0;
    case 2:
        return ldexp(one, power);
    case 3:
        return ldexp(1.0 - 0x1p-53 * (double)(rng_bits(g) % 3), power);
    case 4:
        return pow(10.0, power / 4) * (1.0 + (double)(rng_bits(g) % 3) * 0x1p-52);
    default:
        return floor(1e10 * one) + (double)(rng_bits(g) % 64 * 2 + 1) / 128.0;
    }
}

/** No shorter decimal reads back: an independent search over all counts of digits. */
TEST(writes_the_shortest)
{
    static const struct {
        double value;
        const char *text;
    } known[] = {{0.1, "0.1"},
                 {-0.2, "-0.2"},
                 {0.3, "0.3"},
                 {0.1 + 0.2, "0.30000000000000004"},
                 {1.0 / 3.0, "0.3333333333333333"},
                 {1e23, "1e+23"},
                 {79.5525344881933449, "79.55253448819334"}, /* a half, by 17 digits */
                 {NAN, "nan"},
                 {-NAN, "nan"},
                 {0.015625, "0.015625"},
                 {0x1p-1074, "5e-324"},
                 {DBL_MIN, "2.2250738585072014e-308"},
                 {DBL_MAX, "1.7976931348623157e+308"},
                 {0.0, "0"},
                 {-0.0, "-0"},
                 {2251799813685249.5, "2251799813685249.5"},
                 {9007199254740993.0, "9007199254740992"},
                 {INFINITY, "inf"}};
    rng g = rng_seed(2);
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k)
        assert_string_equal(NUMBER(known[k].value), known[k].text);
    for (int k = 0; k < 120000; ++k) {
        const double x = number_of_kind(k % 6, &g);
        double value;
        char text[NUMBER_TEXT], shorter[40];
        int digits = 1;
        while (snprintf(shorter, sizeof shorter, "%.*g", digits, x), strtod(shorter, NULL) != x)
            ++digits;
        if (digits < DBL_DIG && fabs(x) >= DBL_MIN) /* 12300 is no shorter as 1.23e+04 */
            snprintf(shorter, sizeof shorter, "%.*g", DBL_DIG, x);
        assert_string_equal(number_text(x, text), shorter);
        assert_int_equal(number_read(text, &value), 0);
        assert_same_bits(&value, &x, 1);
    }
}

RUN_TESTS(cmocka_unit_test(reads_to_the_bit), cmocka_unit_test(refuses_and_leaves_the_value),
          cmocka_unit_test(reads_back_what_printf_writes), cmocka_unit_test(writes_the_shortest),
          cmocka_unit_test(reads_long_texts))
