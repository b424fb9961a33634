// Universal Ink files (.uim): messages, versions, packed columns, and what is said of damaged ones.
#include "model/formats/files.h"
#include "model/formats/ink/recording.h"
#include "model/formats/ink/universal_container.h"
#include "model/formats/ink/wire_reader.h"
#include "model/painting/ryb.h"
#include "model/painting/validate.h"

#include <QFile>
#include <QJsonArray>
#include <QRandomGenerator>
#include <QTest>
#include <QtEndian>

#include <cmath>
#include <cstring>

using namespace suffuse;

namespace {

QByteArray varint(quint64 value)
{
    QByteArray bytes;
    for (; value > 127; value >>= 7)
        bytes += char((value & 127) | 128);
    return bytes + char(value);
}

QByteArray whole(int field, quint64 value)
{
    return varint(quint64(field) << 3) + varint(value);
}

quint64 zigzag(qint64 value)
{
    return quint64(value) << 1 ^ quint64(value >> 63);
}

QByteArray block(int field, const QByteArray &bytes)
{
    return varint(quint64(field) << 3 | 2) + varint(quint64(bytes.size())) + bytes;
}

QByteArray four(float value)
{
    QByteArray bytes(4, 0);
    qToLittleEndian(value, bytes.data());
    return bytes;
}

QByteArray floats(int field, const std::vector<float> &values)
{
    QByteArray bytes;
    for (const float value : values)
        bytes += four(value);
    return block(field, bytes);
}

QByteArray signedValues(int field, const std::vector<int> &values)
{
    QByteArray bytes;
    for (const int value : values)
        bytes += varint(zigzag(value));
    return block(field, bytes);
}

QByteArray chunk(const QByteArray &name, const QByteArray &content)
{
    QByteArray size(4, 0);
    qToLittleEndian(quint32(content.size()), size.data());
    return name + size + content + QByteArray(content.size() & 1, 0);
}

QByteArray container(const QByteArray &chunks)
{
    return chunk("RIFF", "UINK" + chunks);
}

/// What describes a chunk: its version, that it is a message, and that it is not packed.
const QByteArray described("\3\1\0\1\0\0\0\0", 8);

/// Two strokes of version 3.1: one with its values, one with differences of whole numbers, of one sensor's data.
QByteArray file31()
{
    const QByteArray channels =
        block(2, block(1, "T") + block(2, "will://input/3.0/channel/Timestamp") + QByteArray("\x21", 1) +
                     QByteArray("\0\0\0\0\0\x40\x8f\x40", 8)) + // 1000 a second
        block(2, block(1, "P") + block(2, "will://input/3.0/channel/Pressure") + whole(7, 2));
    const QByteArray input = block(1, block(5, block(2, channels))) +
                             block(2, block(1, QByteArray("\1\2", 2)) + whole(4, 5000) +
                                          block(5, block(1, "T") + signedValues(2, {0, 8, 8, 8})) +
                                          block(5, block(1, "P") + signedValues(2, {25, 25, 25, 25})));
    const QByteArray plain = block(5, floats(1, {0, 10, 20, 30}) + floats(2, {0, 5, 5, 0})) + whole(7, 1) +
                             whole(9, 1) + block(15, QByteArray("\1\2", 2));
    const QByteArray packed = whole(2, zigzag(0x12)) +
                              block(6, signedValues(1, {1000, 1000, 1000, 1000}) +
                                           signedValues(2, {-500, 100, 100, 100}) + signedValues(8, {15, 5, 5, 5})) +
                              whole(7, 2);
    const QByteArray ink = block(1, plain) + block(1, packed) + block(4, "will://brushes/a") +
                           block(6, whole(1, zigzag(qint32(0xff0000ff))) + QByteArray("\x15", 1) + four(3)) +
                           block(6, whole(1, zigzag(qint32(0x0000ff80))));
    const QByteArray brushes = block(1, block(1, "will://brushes/a") +
                                            block(2, block(5, "will://brush/3.0/shape/Circle?precision=8&radius=0.5")));
    return container(chunk("HEAD", QByteArray("\3\1\0\0", 4) + described + described + described) +
                     chunk("INPT", input) + chunk("BRSH", brushes) + chunk("INKD", ink));
}

/// One stroke of version 3.0.
QByteArray file30()
{
    const QByteArray style = block(22, block(1, block(1, QByteArray("\xd", 1) + four(2)) + block(3, "") +
                                                    block(2, QByteArray("\xd", 1) + four(1))));
    const QByteArray stroke = floats(4, {0, 10, 20}) + floats(5, {0, 5, 9}) + floats(11, {1, 2, 3}) + style;
    return container(chunk("HEAD", QByteArray("\3\0\0", 3)) + chunk("DATA", block(2, block(1, stroke))));
}

} // namespace

class TestUniversalContainer : public QObject {
    Q_OBJECT

private slots:
    void messagesAreRead()
    {
        static constexpr WireField inner[] = {{1, "name"}, {3, "sizes", WireKind::Whole, true}};
        static constexpr WireField fields[] = {{1, "id", WireKind::Identifier},
                                               {2, "shift", WireKind::Signed},
                                               {4, "parts", WireKind::Message, true, inner}};
        qint64 budget = 1000;
        // Lists of numbers may be packed or not; what nobody knows is passed over.
        const QByteArray bytes =
            block(1, QByteArray("\0\xab", 2)) + whole(2, zigzag(-3)) + whole(99, 7) + block(98, "xx") +
            block(4, block(1, "a") + block(3, varint(300) + varint(2)) + whole(3, 5)) + block(4, "");
        const auto object = readWire(bytes, fields, budget);
        QVERIFY(object.has_value());
        QCOMPARE(object->value("id").toString(), QString("00ab"));
        QCOMPARE(object->value("shift").toDouble(), -3.0);
        QCOMPARE(object->value("parts").toArray().size(), 2);
        QCOMPARE(object->value("parts")[0]["sizes"].toArray(), (QJsonArray{300, 2, 5}));
        QCOMPARE(object->value("parts")[0]["name"].toString(), QString("a"));
        QVERIFY(budget < 1000);
        for (qsizetype size = 1; size < bytes.size(); ++size) { // cut off: damaged, or whole by chance
            budget = 1000;
            readWire(QByteArrayView(bytes).first(size), fields, budget);
        }
        budget = 3;
        QVERIFY(!readWire(bytes, fields, budget));
        QVERIFY(budget < 0);
        budget = 1000;
        QVERIFY(!readWire(QByteArray("\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff\xff", 12), fields, budget));
        QVERIFY(!readWire(block(2, "x"), fields, budget));         // no number
        QVERIFY(!readWire(QByteArray("\x0b", 1), fields, budget)); // a packing that there is not any more
    }

    void version31()
    {
        const auto read = readUniversalInk(file31(), "a.uim");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->paths.size(), std::size_t(2));
        const Recording::Path &plain = read->paths[0], &packed = read->paths[1];
        QCOMPARE(plain.samples.size(), std::size_t(4));
        QCOMPARE(plain.samples[2].position, (Point{20, 5}));
        QCOMPARE(plain.samples[3].time, 5'024'000); // µs: 5 s, and three times 8 ms
        QCOMPARE(plain.samples[1].pressure, 0.5f);
        QCOMPARE(plain.samples[3].pressure, 1.0f);
        QCOMPARE(plain.widths[0], 3.0); // the size times the circle's diameter
        QVERIFY(srgbFromRyb(*plain.colour)[0] > 0.99);
        // 1000 with two decimals are 10, and 15 with one are 1.5.
        QVERIFY(length(packed.samples.front().position - Point{10, -5}) < 1e-9);
        QVERIFY(length(packed.samples.back().position - Point{40, -2}) < 1e-9);
        QVERIFY(std::abs(packed.widths.front() - 3) < 1e-9 && std::abs(packed.widths.back() - 6) < 1e-9);
        QVERIFY(std::abs(double(packed.colour->opacity) - 128.0 / 255) < 1e-6);
        const auto painting = readDocument(file31(), "a.ink");
        QVERIFY(painting && painting->painting.strokes.size() == 2);
        QCOMPARE(int(painting->format), int(FileFormat::UniversalInk));
    }

    void version30()
    {
        const auto read = readUniversalInk(file30(), "a.uim");
        QVERIFY2(read, read ? "" : qPrintable(read.error()));
        QCOMPARE(read->paths.size(), std::size_t(1));
        QCOMPARE(read->paths[0].samples.back().position.x, 20.0);
        QCOMPARE(read->paths[0].widths.back(), 6.0);
        const std::array<double, 3> rgb = srgbFromRyb(*read->paths[0].colour);
        QVERIFY(rgb[0] > 0.99 && rgb[1] < 0.01); // a channel of 0 is an empty message
    }

    /// The same recording, as others wrote it in both ways.
    void isWhatJsonIs()
    {
        QFile packed(QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/ink/digital_ink.uim")),
            text(QStringLiteral(SUFFUSE_SOURCE_DIR "/../shared/data/ink/digital_ink.json"));
        if (!packed.open(QIODevice::ReadOnly) || !text.open(QIODevice::ReadOnly))
            QSKIP("../shared/data is missing");
        const auto a = readUniversalInk(packed.readAll(), "a.uim"), b = readUniversalInk(text.readAll(), "b.json");
        QVERIFY2(a, a ? "" : qPrintable(a.error()));
        QVERIFY(bool(b));
        QCOMPARE(a->paths.size(), b->paths.size() + 1); // one stroke was added years later
        for (std::size_t k = 0; k < b->paths.size(); ++k) {
            const Recording::Path &p = a->paths[k], &q = b->paths[k];
            QCOMPARE(p.samples.size(), q.samples.size());
            QCOMPARE(p.widths.size(), q.widths.size());
            for (std::size_t i = 0; i < p.samples.size(); ++i) {
                QVERIFY(length(p.samples[i].position - q.samples[i].position) <= 0.01); // two decimals are kept
                QVERIFY(std::abs(p.samples[i].time - q.samples[i].time) <= 1000);
                QVERIFY(std::abs(p.samples[i].pressure - q.samples[i].pressure) <= 0.01f);
            }
        }
    }

    void damagedFilesAreRefused()
    {
        const auto errorOf = [](const QByteArray &bytes) {
            const auto read = readPainting(bytes, "a.uim");
            return read ? QStringLiteral("no error") : read.error();
        };
        const QByteArray good = file31();
        QVERIFY(errorOf(good.left(60)).contains("damaged"));
        QVERIFY(errorOf(container(chunk("HEAD", QByteArray("\2\0\0\0", 4)))).contains("2.0"));
        QVERIFY(errorOf(container(chunk("HEAD", QByteArray("\3\1\0\0\3\1\0\1\1\0\0\0", 12)) + chunk("INKD", "")))
                    .contains("packed"));
        // Strokes that take two bytes each would take hundreds in memory.
        const QByteArray empty = QByteArray("\x0a\x00", 2).repeated(1 << 20);
        QVERIFY(errorOf(container(chunk("HEAD", QByteArray("\3\1\0\0", 4) + described) + chunk("INKD", empty)))
                    .contains("more than"));
        QRandomGenerator random(1);
        for (int k = 0; k < 1000; ++k) {
            QByteArray bytes = k % 2 ? file31() : file30();
            for (int i = 0; i < 3; ++i)
                bytes[12 + random.bounded(int(bytes.size()) - 12)] = char(random.bounded(256));
            const auto read = readPainting(bytes, "a.uim");
            QVERIFY(!read || problemOf(*read).isEmpty());
        }
    }
};

QTEST_GUILESS_MAIN(TestUniversalContainer)
#include "test_universal_container.moc"
