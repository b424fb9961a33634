#include "model/formats/svg/svg_embedding.h"

#include <QCryptographicHash>

namespace suffuse {

namespace {

const QByteArray embeddingOpening = "<metadata><suffuse:painting xmlns:suffuse=\"urn:suffuse:painting\" drawing=\"";
const QByteArray embeddingClosing = "</suffuse:painting></metadata>\n";
const QByteArray drawingEnd = "</svg>";
const QByteArray embeddingElement = "<suffuse:painting";
constexpr qsizetype embeddingHashLetters = 64;
constexpr qsizetype embeddingLineLetters = 120;

/// Of the drawing without the painting.
QByteArray hashOfDrawing(QByteArrayView before, QByteArrayView after)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(before);
    hash.addData(after);
    return hash.result().toHex();
}

} // namespace

QByteArray withEmbedded(const QByteArray &svg, const QByteArray &document)
{
    const qsizetype at = svg.lastIndexOf(drawingEnd);
    const QByteArray letters = document.toBase64();
    QByteArray out = svg.first(at);
    out += embeddingOpening + hashOfDrawing(QByteArrayView(svg).first(at), QByteArrayView(svg).sliced(at)) + "\">";
    for (qsizetype from = 0; from < letters.size(); from += embeddingLineLetters)
        out += '\n' + letters.mid(from, embeddingLineLetters);
    return out + embeddingClosing + svg.sliced(at);
}

std::optional<EmbeddedDocument> embeddedIn(const QByteArray &svg)
{
    const qsizetype begin = svg.lastIndexOf(embeddingElement);
    if (begin < 0)
        return {};
    const qsizetype from = svg.indexOf('>', begin) + 1, to = svg.indexOf('<', from);
    if (from == 0 || to < 0)
        return {};
    const auto decoded = QByteArray::fromBase64Encoding(svg.sliced(from, to - from).simplified().replace(' ', ""));
    if (!decoded)
        return {};
    EmbeddedDocument out{*decoded, false};
    const qsizetype start = svg.lastIndexOf(embeddingOpening);
    const qsizetype end = svg.indexOf(embeddingClosing, to);
    if (start < 0 || end < 0 || start + embeddingOpening.size() + embeddingHashLetters + 2 != from)
        return out;
    const QByteArrayView whole(svg);
    out.matches = hashOfDrawing(whole.first(start), whole.sliced(end + embeddingClosing.size())) ==
                  svg.sliced(start + embeddingOpening.size(), embeddingHashLetters);
    return out;
}

} // namespace suffuse
