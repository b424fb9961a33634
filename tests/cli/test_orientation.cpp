// How photographs stand: what formats of images say of it, and what is made of that.
#include "render/image_io/image_io.h"
#include "render/image_io/orientation.h"
#include "render/scene/paper.h"
#include "tests/cli/image_bytes.h"
#include "tests/files.h"

#include <QPoint>
#include <QSize>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>
#include <memory>

using namespace suffuse;

namespace {

FloatPicture moved(const FloatPicture &p, int width, int height, const std::function<QPoint(int, int)> &to)
{
    FloatPicture out;
    out.resize(width, height);
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x)
            std::copy_n(p.rgba.data() + (std::size_t(y) * p.width + x) * 4, 4,
                        out.rgba.data() + (std::size_t(to(x, y).y()) * width + to(x, y).x()) * 4);
    return out;
}

FloatPicture mirrored(const FloatPicture &p)
{
    return moved(p, p.width, p.height, [&](int x, int y) { return QPoint(p.width - 1 - x, y); });
}

/// By 90° clockwise, so many times.
FloatPicture turned(FloatPicture p, int times)
{
    for (; times > 0; --times)
        p = moved(p, p.height, p.width, [&](int x, int y) { return QPoint(p.height - 1 - y, x); });
    return p;
}

/// Exif's orientations in words: 6 is a picture that is upright once it is turned clockwise.
FloatPicture upright(const FloatPicture &p, int exif)
{
    switch (exif) {
    case 2:
        return mirrored(p);
    case 3:
        return turned(p, 2);
    case 4:
        return mirrored(turned(p, 2));
    case 5:
        return mirrored(turned(p, 1));
    case 6:
        return turned(p, 1);
    case 7:
        return mirrored(turned(p, 3));
    case 8:
        return turned(p, 3);
    default:
        return p;
    }
}

/// As a phone writes it: an orientation between other tags.
QByteArray exifData(char orientation)
{
    const QByteArray type("\0\x03\0\0\0\x01", 6), end("\0\0", 2);
    return QByteArray("MM\0*\0\0\0\x08\0\x03", 10) + "\x01\x10" + type + QByteArray("\0\x07", 2) + end + "\x01\x12" +
           type + '\0' + orientation + end + "\x01\x28" + type + QByteArray("\0\x02", 2) + end + QByteArray(4, 0);
}

} // namespace

class TestOrientation : public QObject {
    Q_OBJECT

private slots:
    void orientation_data();
    void orientation();
    void damagedOrientation();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }

    QTemporaryDir m_folder;
};

void TestOrientation::orientation_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("exif");
    for (const char *name : {"phone.jpg", "phone.png", "phone.webp", "phone.tif"})
        for (int exif = 0; exif <= 9; ++exif) // 0 and 9 mean nothing
            QTest::newRow(qPrintable(QStringLiteral("%1 %2").arg(name).arg(exif))) << QString(name) << exif;
}

/// Photographs stand upright, wherever their format keeps how the camera was held.
void TestOrientation::orientation()
{
    QFETCH(QString, name);
    QFETCH(int, exif);
    FloatPicture picture = ramp(40, 24);
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
        picture.rgba[i] = 1;
    QVERIFY(writeImage(path(name), picture, {}));
    QByteArray bytes = bytesOf(path(name));
    const auto plain = readImage(bytes, name);
    QVERIFY(plain);
    QCOMPARE(QSize(plain->width, plain->height), QSize(40, 24));
    const QByteArray data = exifData(char(exif));
    if (name.endsWith("jpg")) {
        const QByteArray body = QByteArray("Exif\0\0", 6) + data;
        bytes.insert(2, QByteArray("\xFF\xE1") + bigEndian(quint32(body.size() + 2)).right(2) + body);
    } else if (name.endsWith("png")) {
        bytes.insert(33, bigEndian(quint32(data.size())) + "eXIf" + data + QByteArray(4, 0));
    } else if (name.endsWith("webp")) {
        const auto littleEndian = [](quint32 v) {
            QByteArray b = bigEndian(v);
            std::reverse(b.begin(), b.end());
            return b;
        };
        bytes += "EXIF" + littleEndian(quint32(data.size())) + data;
        bytes.replace(4, 4, littleEndian(quint32(bytes.size() - 8)));
    } else {
        const qsizetype tag = bytes.indexOf(QByteArray("\x12\x01\x03\0\x01\0\0\0\x01\0", 10));
        QVERIFY(tag > 0);
        bytes[tag + 8] = char(exif);
    }
    const auto read = readImage(bytes, name);
    QVERIFY2(read, qPrintable(read.error()));
    const FloatPicture expected = upright(*plain, exif);
    QCOMPARE(QSize(read->width, read->height), QSize(expected.width, expected.height));
    QVERIFY(read->rgba == expected.rgba);

    Paper paper;
    paper.kind = PaperKind::Image;
    paper.image = std::make_shared<const QByteArray>(bytes);
    const auto texture = paperTexture(paper);
    QVERIFY(texture);
    QCOMPARE(QSize((*texture)->width, (*texture)->height), QSize(expected.width, expected.height));
}

/// What cannot be understood is upright, wherever the bytes end.
void TestOrientation::damagedOrientation()
{
    const QByteArray data = exifData(6);
    const QByteArray body = QByteArray("Exif\0\0", 6) + data;
    const QByteArray jpeg = "\xFF\xD8\xFF\xE1" + bigEndian(quint32(body.size() + 2)).right(2) + body;
    const QByteArray png = QByteArray(8, 'p') + bigEndian(quint32(data.size())) + "eXIf" + data;
    QCOMPARE(orientationOf(jpeg, ImageFormat::Jpeg).exif(), 6);
    QCOMPARE(orientationOf(png, ImageFormat::Png).exif(), 6);
    QCOMPARE(orientationOf(data, ImageFormat::Tiff).exif(), 6);
    QCOMPARE(orientationOf(data, ImageFormat::Exr).exif(), 1);
    for (const auto &[bytes, format] :
         {std::pair{jpeg, ImageFormat::Jpeg}, {png, ImageFormat::Png}, {data, ImageFormat::Tiff}})
        for (qsizetype i = 0; i < bytes.size(); ++i) {
            const int cut = orientationOf(bytes.left(i), format).exif();
            QVERIFY(cut == 1 || cut == 6);
            for (const char byte : {'\0', '\x7F', '\xFF'}) { // lengths, offsets and counts out of bounds among them
                QByteArray damaged = bytes;
                damaged[i] = byte;
                const int exif = orientationOf(damaged, format).exif();
                QVERIFY(exif >= 1 && exif <= 8);
            }
        }
}

QTEST_GUILESS_MAIN(TestOrientation)
#include "test_orientation.moc"
