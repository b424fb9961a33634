// Every SIMD instruction set of this machine draws the same picture, to a level of 8 bits.
#include "cli_process.h"

#include "model/formats/files.h"
#include "render/image_io/image_io.h"
#include "tests/render/paintings.h"

using namespace suffuse;

class TestSimdTargets : public QObject {
    Q_OBJECT

    /// The picture, or an empty one where this machine lacks the instruction set.
    static FloatPicture drawn(const QString &painting, const QString &picture, const QString &set)
    {
        const CliOutcome outcome = runCli({"render", painting, "-o", picture, "--size", "260x202", "--stats"}, {},
                                          set.isEmpty() ? QStringList{} : QStringList{"SUFFUSE_SIMD=" + set});
        const QString device = outcome.json()["device"].toString();
        if (outcome.code != 0 || !(set.isEmpty() || device.endsWith(set == "AVX3" ? "AVX-512" : set)))
            return {};
        auto image = readImage(readFile(picture), picture);
        return image ? *image : FloatPicture{};
    }

private slots:
    void agreeToALevel()
    {
        QTemporaryDir folder;
        std::mt19937_64 random(19);
        const QString file = folder.filePath("strokes.suffuse"), picture = folder.filePath("strokes.png");
        const auto p = test::painting(test::randomStrokes(random, 40, 260, 202), 260, 202,
                                      {PaperKind::Procedural, 1, 16, 0.7f, {}});
        QVERIFY(savePainting(*p, file));
        const FloatPicture best = drawn(file, picture, {});
        QCOMPARE(best.width, 260);
        int sets = 0;
        for (const QString set : {"SCALAR", "SSE4", "AVX2", "AVX3", "NEON"}) {
            const FloatPicture other = drawn(file, picture, set);
            if (other.width == 0)
                continue;
            ++sets;
            QCOMPARE(other.rgba.size(), best.rgba.size());
            QVERIFY2(test::worst(best, other).difference * 255 < 1.01, qPrintable(set));
        }
        QVERIFY(sets > 0);
    }
};

QTEST_GUILESS_MAIN(TestSimdTargets)
#include "test_simd_targets.moc"
