// Numbers that are not numbers, have no end or are extreme, in any member of a painting: refused at the border with the
// member's path, or drawn without a NaN. 10,000 paintings; SUFFUSE_LONG=1: a million (tests/trials.h).
#include "model/formats/files.h"
#include "model/painting/validate.h"
#include "tests/render/paintings.h"
#include "tests/trials.h"

#include <QRandomGenerator>

#include <cmath>

using namespace suffuse;
using namespace suffuse::test;

namespace {

/// Every member that holds numbers.
constexpr const char *base = R"({"format": "suffuse-text", "version": 1,
 "canvas": {"width": 24, "height": 18, "background": [0.1, 0.2, 0.3, 0.5],
  "paper": {"kind": "procedural", "seed": 3, "scale": 2, "strength": 0.5}},
 "groups": [{"id": 1, "name": "", "parent": null, "visible": true, "locked": false}],
 "swatches": [{"name": "", "colour": [0.2, 0.8, 0.1, 1]}],
 "strokes": [{"id": 1, "name": "", "group": 1, "visible": true, "locked": false, "origin": [2, 3],
   "style": {"kind": "uniform", "xi": [0.5, 0.05]}, "mix": {"mode": "beta", "beta": 0.8},
   "segments": [{"bezier": [[0, 0], [3, 1], [6, 4], [9, 5]], "diffusion": 2.5, "density": 9, "granulation": 0.5, "maxAge": 1,
     "born": 0.016, "colour": [0.25, 0.5, 1, 0.75], "anisotropy": {"ratio": 2, "angle": 0.5}, "rewet": [[2, 0.5], [4, 1]]},
    {"bezier": [[9, 5], [12, 6], [14, 9], [16, 12]], "diffusion": 1.5, "density": 5, "granulation": 1, "maxAge": 2,
     "born": 0.1, "colour": [1, 0.5, 0, 1], "style": {"kind": "edge", "xi": [0.5, 0.3, 0.05]}}]},
  {"id": 2, "name": "", "group": null, "visible": true, "locked": false,
   "style": {"kind": "feathering", "xi": [0.6, 2]}, "mix": {"mode": "alpha"},
   "segments": [{"bezier": [[2, 15], [9, 14], [14, 3], [22, 4]], "diffusion": 4, "density": 7, "granulation": 0.8, "maxAge": 1,
     "born": 0.5, "colour": [0, 0.5, 0.5, 1]}]}]})";

struct Number {
    qsizetype at = 0, size = 0;
    QString path; ///< "strokes[0].segments[1].density"
};

/// Where the numbers of a JSON text stand; the text is known to be whole.
std::vector<Number> numbersOf(const QByteArray &text)
{
    struct Level {
        bool isList = false;
        int index = 0;
        QString key;
    };
    std::vector<Level> levels;
    const auto path = [&] {
        QString result;
        for (const Level &level : levels)
            result += level.isList                              ? QStringLiteral("[%1]").arg(level.index)
                      : result.isEmpty() || level.key.isEmpty() ? level.key
                                                                : '.' + level.key;
        return result;
    };
    std::vector<Number> numbers;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '{' || c == '[') {
            levels.push_back({c == '[', 0, {}});
        } else if (c == '}' || c == ']') {
            levels.pop_back();
        } else if (c == ',' && levels.back().isList) {
            ++levels.back().index;
        } else if (c == '"') {
            const qsizetype end = text.indexOf('"', i + 1);
            if (text[end + 1] == ':')
                levels.back().key = QString::fromUtf8(text.mid(i + 1, end - i - 1));
            i = end;
        } else if (c == '-' || (c >= '0' && c <= '9')) {
            const qsizetype from = i;
            while (QByteArrayView("+-.eE0123456789").contains(text[i + 1]))
                ++i;
            numbers.push_back({from, i + 1 - from, path()});
        }
    }
    return numbers;
}

QByteArray extreme(QRandomGenerator &random)
{
    static constexpr const char *values[] = {"NaN",
                                             "-NaN",
                                             "Infinity",
                                             "-Infinity",
                                             "1e999",
                                             "-1e999",
                                             "1e308",
                                             "-1e308",
                                             "1e39",
                                             "3.4028235e38",
                                             "-3.4028235e38",
                                             "1e30",
                                             "1e20",
                                             "-1e20",
                                             "1e12",
                                             "1.1e12",
                                             "1e6",
                                             "1000000.5",
                                             "-1e6",
                                             "-1",
                                             "0",
                                             "-0",
                                             "1e-6",
                                             "1e-30",
                                             "1e-38",
                                             "1.4e-45",
                                             "1e-46",
                                             "5e-324",
                                             "1e-400",
                                             "9007199254740993",
                                             "18446744073709551615",
                                             "18446744073709551616",
                                             "-9223372036854775809",
                                             "0.5",
                                             "1",
                                             "1.0000001",
                                             "2",
                                             "null",
                                             "true",
                                             "\"1\"",
                                             "[]"};
    if (random.bounded(4) != 0)
        return values[random.bounded(int(std::size(values)))];
    const double power = std::pow(10, random.generateDouble() * 80 - 40); // any size that a float has
    return QByteArray::number(random.bounded(2) ? power : -power, 'g', 9);
}

} // namespace

class TestExtremeNumbers : public QObject {
    Q_OBJECT

private slots:
    void theBaseIsGood()
    {
        const Result<Painting> p = readTextForm(base, QStringLiteral("a.json"));
        QVERIFY2(p, qPrintable(p ? QString() : p.error()));
        QVERIFY(numbersOf(base).size() > 80);
    }

    void refusedOrDrawn()
    {
        const int count = trials(10'000, 1'000'000);
        const auto renderer = make(Backend::Cpu);
        QRandomGenerator random(11 + firstSeed());
        const std::vector<Number> numbers = numbersOf(base);
        int refused = 0, drawn = 0;
        for (int i = 0; i < count; ++i) {
            QByteArray text = base;
            std::vector<std::size_t> changed;
            for (int k = random.bounded(2); k >= 0; --k)
                changed.push_back(std::size_t(random.bounded(int(numbers.size()))));
            std::sort(changed.rbegin(), changed.rend()); // from behind, so that places stay
            changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
            QStringList paths;
            for (std::size_t n : changed) {
                text.replace(numbers[n].at, numbers[n].size, extreme(random));
                paths << numbers[n].path;
            }
            const Result<Painting> painting = readTextForm(text, QStringLiteral("a.json"));
            if (!painting) {
                ++refused;
                // The member itself; where two do not fit together the other one: in the same object, the next segment,
                // or what has or wants this id.
                const bool names = std::any_of(paths.begin(), paths.end(), [&](const QString &path) {
                    const int depth = path.contains(".bezier") ? 0 : int(path.count('.')) - 1;
                    return painting.error().contains(path.section('.', 0, std::max(depth, 0))) ||
                           (path.endsWith("id") && painting.error().contains(" id"));
                });
                QVERIFY2(names, qPrintable(paths.join(' ') + " / " + painting.error()));
                continue;
            }
            ++drawn;
            QCOMPARE(problemOf(*painting), QString());
            const auto shared = std::make_shared<const Painting>(*painting);
            const Microseconds time = random.bounded(2) ? shared->end() : Microseconds(random.bounded(3'000'000));
            const int width = i % 4 == 0 ? 24 : 8; // a few paintings have so many nodes that each pixel takes long
            const View view = View::ofArea(Rect::of(0, 0, 24, 18), width, width * 3 / 4);
            const FloatPicture picture = test::render(*renderer, shared, view, time);
            for (float value : picture.rgba)
                QVERIFY2(value >= -1e-6f && value <= 1 + 1e-6f, text.constData()); // false for NaN
        }
        qInfo("%d refused, %d drawn", refused, drawn);
        QVERIFY(refused > count / 5 && drawn > count / 10);
    }
};

QTEST_GUILESS_MAIN(TestExtremeNumbers)
#include "test_extreme_numbers.moc"
