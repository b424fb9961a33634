#include "render/tiles/deep_zoom_page.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace suffuse {

namespace {

constexpr char start[] = R"html(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="Suffuse )html";

constexpr char head[] = SUFFUSE_VERSION R"html(">
<style>
html, body { margin: 0; height: 100%; overflow: hidden; background: #808080; }
canvas { display: block; width: 100%; height: 100%; touch-action: none; cursor: grab; outline: none; }
canvas:active { cursor: grabbing; }
</style>
</head>
<body>
<canvas tabindex="0" aria-label="The picture. Arrow keys move it, plus and minus zoom, 0 shows all of it, 1 its pixels."></canvas>
<script>
"use strict";
const picture = )html";

constexpr char tail[] = R"html(;
document.title = picture.title;
const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");
const top_ = Math.ceil(Math.log2(Math.max(picture.width, picture.height))); // the level of the whole picture
const most = 400; // tiles that are kept
const tiles = new Map(); // by name; those that were used last come last
const view = { x: 0, y: 0, scale: 1 }; // the picture's pixel in the corner, and the screen's pixels for one of them
let isAsked = false, ratio = 1;

function tileAt(level, column, row) {
  const name = picture.files + "/" + level + "/" + column + "_" + row + "." + picture.ending;
  let tile = tiles.get(name);
  if (tile) {
    tiles.delete(name);
  } else {
    tile = new Image();
    tile.onload = draw;
    tile.src = encodeURI(name);
  }
  tiles.set(name, tile);
  return tile;
}

// Draws the tiles of a level that are seen and have come. Levels below fill the gaps.
function drawLevel(level, asks) {
  const factor = 2 ** (top_ - level), side = picture.tile * factor;
  const columns = Math.ceil(Math.ceil(picture.width / factor) / picture.tile);
  const rows = Math.ceil(Math.ceil(picture.height / factor) / picture.tile);
  const left = Math.max(0, Math.floor(view.x / side)), above = Math.max(0, Math.floor(view.y / side));
  const right = Math.min(columns, Math.ceil((view.x + canvas.width / view.scale) / side));
  const below = Math.min(rows, Math.ceil((view.y + canvas.height / view.scale) / side));
  let whole = true;
  for (let row = above; row < below; ++row)
    for (let column = left; column < right; ++column) {
      const tile = asks ? tileAt(level, column, row)
                        : tiles.get(picture.files + "/" + level + "/" + column + "_" + row + "." + picture.ending);
      if (!tile || !tile.complete || !tile.naturalWidth) {
        whole = false;
        continue;
      }
      const x = column * side - (column > 0 ? picture.overlap * factor : 0);
      const y = row * side - (row > 0 ? picture.overlap * factor : 0);
      pen.drawImage(tile, (x - view.x) * view.scale, (y - view.y) * view.scale, tile.naturalWidth * factor * view.scale,
                    tile.naturalHeight * factor * view.scale);
    }
  return whole;
}

function drawNow() {
  isAsked = false;
  pen.fillStyle = "#808080";
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.imageSmoothingEnabled = view.scale < 2;
  pen.save();
  pen.beginPath();
  pen.rect(-view.x * view.scale, -view.y * view.scale, picture.width * view.scale, picture.height * view.scale);
  pen.clip();
  const level = Math.max(0, Math.min(top_, Math.ceil(top_ + Math.log2(view.scale) - 0.01)));
  for (let coarse = Math.max(0, level - 8); coarse < level; ++coarse)
    drawLevel(coarse, coarse === level - 3 || coarse === Math.max(0, level - 8));
  document.body.dataset.whole = drawLevel(level, true);
  pen.restore();
  for (const name of tiles.keys()) {
    if (tiles.size <= most)
      break;
    tiles.delete(name);
  }
}

function draw() {
  if (!isAsked)
    requestAnimationFrame(drawNow);
  isAsked = true;
}

const smallest = () => Math.min(canvas.width / picture.width, canvas.height / picture.height, 1);

// Zooms so that what lies under a point of the screen stays there.
function zoom(factor, x, y) {
  const scale = Math.max(smallest() / 2, Math.min(64, view.scale * factor));
  view.x += x / view.scale - x / scale;
  view.y += y / view.scale - y / scale;
  view.scale = scale;
  settle();
}

function move(dx, dy) {
  view.x -= dx / view.scale;
  view.y -= dy / view.scale;
  settle();
}

// Some of the picture stays on the screen.
function settle() {
  const width = canvas.width / view.scale, height = canvas.height / view.scale;
  view.x = Math.max(-width / 2, Math.min(picture.width - width / 2, view.x));
  view.y = Math.max(-height / 2, Math.min(picture.height - height / 2, view.y));
  draw();
}

function showAll() {
  view.scale = smallest();
  view.x = (picture.width - canvas.width / view.scale) / 2;
  view.y = (picture.height - canvas.height / view.scale) / 2;
  draw();
}

function resize() {
  const first = ratio !== devicePixelRatio || !canvas.dataset.ready;
  ratio = devicePixelRatio;
  canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  canvas.dataset.ready = "yes";
  first ? showAll() : settle();
}

const fingers = new Map();
canvas.addEventListener("pointerdown", event => {
  canvas.setPointerCapture(event.pointerId);
  fingers.set(event.pointerId, { x: event.offsetX * ratio, y: event.offsetY * ratio });
});
for (const end of ["pointerup", "pointercancel"])
  canvas.addEventListener(end, event => fingers.delete(event.pointerId));
canvas.addEventListener("pointermove", event => {
  const was = fingers.get(event.pointerId);
  if (!was)
    return;
  const now = { x: event.offsetX * ratio, y: event.offsetY * ratio };
  const other = [...fingers].find(([id]) => id !== event.pointerId);
  if (other) {
    const at = other[1];
    const before = Math.hypot(was.x - at.x, was.y - at.y), after = Math.hypot(now.x - at.x, now.y - at.y);
    move((now.x - was.x) / 2, (now.y - was.y) / 2);
    if (before > 0 && after > 0)
      zoom(after / before, (now.x + at.x) / 2, (now.y + at.y) / 2);
  } else {
    move(now.x - was.x, now.y - was.y);
  }
  fingers.set(event.pointerId, now);
});
canvas.addEventListener("wheel", event => {
  event.preventDefault();
  const lines = event.deltaMode === 1 ? 16 : 1;
  zoom(2 ** (-event.deltaY * lines / (event.ctrlKey ? 60 : 240)), event.offsetX * ratio, event.offsetY * ratio);
}, { passive: false });
canvas.addEventListener("dblclick", event => zoom(2, event.offsetX * ratio, event.offsetY * ratio));
addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey)
    return;
  const x = canvas.width / 2, y = canvas.height / 2, step = Math.min(x, y) / 4;
  const keys = {
    ArrowLeft: () => move(step, 0), ArrowRight: () => move(-step, 0), ArrowUp: () => move(0, step), ArrowDown: () => move(0, -step),
    "+": () => zoom(2, x, y), "=": () => zoom(2, x, y), "-": () => zoom(0.5, x, y),
    "0": showAll, Home: showAll, "1": () => zoom(1 / view.scale, x, y),
  };
  if (keys[event.key]) {
    event.preventDefault();
    keys[event.key]();
  }
});
addEventListener("resize", resize);
resize();
</script>
</body>
</html>
)html";

} // namespace

QByteArray deepZoomPage(const DeepZoomPage &page)
{
    QString title = page.files;
    title.chop(int(qstrlen("_files")));
    const QJsonObject values{{"title", title},         {"files", page.files},   {"ending", page.ending},
                             {"width", page.width},    {"height", page.height}, {"tile", page.tile},
                             {"overlap", page.overlap}};
    QByteArray json = QJsonDocument(values).toJson(QJsonDocument::Compact);
    json.replace('<', "\\u003c"); // A name must not end the script.
    return start + (head + json) + tail;
}

bool isDeepZoomPage(const QByteArray &bytes)
{
    return bytes.startsWith(start);
}

} // namespace suffuse
