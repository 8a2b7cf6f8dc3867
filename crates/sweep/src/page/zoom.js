// Charts and maps in large, on the pages of `sweep report` and `sweep explore`.
//
//   enlargeable(panel)   gives a panel its button, which opens it in a dialog: larger and smaller by
//                        buttons or the keys + − 0, moved by scrolling, by dragging or by a finger
//
// The panel itself moves into the dialog and back: a map answers there, too.

/** How much larger each step is, and the largest. */
const ZOOM_STEP = 1.5;
const ZOOM_MOST = 12;

const zoomed = (() => {
  const button = (name, label, act) => {
    const made = make("button", { type: "button", "aria-label": label, title: label }, name);
    made.addEventListener("click", act);
    return made;
  };
  const content = make("div", { class: "zoom-content" });
  const room = make("div", { class: "zoom-room", tabindex: "0", role: "region", "aria-label": "The picture; scroll to move it" }, content);
  const dialog = make("dialog", { class: "zoom", "aria-label": "Picture in large" });
  let place = null;
  let opener = null;
  let factor = 1;
  /** The width at which all of it is seen. */
  const whole = () => {
    const area = content.querySelector(".area");
    const shape = area ? area.clientWidth / area.clientHeight : 1;
    const around = content.scrollHeight - (area?.clientHeight ?? 0);
    return Math.max(240, Math.min(room.clientWidth - 8, (room.clientHeight - around) * shape));
  };
  const zoom = (to) => {
    const before = content.offsetWidth;
    const middle = [room.scrollLeft + room.clientWidth / 2, room.scrollTop + room.clientHeight / 2];
    factor = Math.min(ZOOM_MOST, Math.max(1, to));
    if (factor === 1) content.style.width = `${room.clientWidth - 8}px`;
    content.style.width = `${whole() * factor}px`;
    const grown = content.offsetWidth / before;
    room.scrollLeft = middle[0] * grown - room.clientWidth / 2;
    room.scrollTop = middle[1] * grown - room.clientHeight / 2;
  };
  const larger = () => zoom(factor * ZOOM_STEP);
  const smaller = () => zoom(factor / ZOOM_STEP);
  dialog.append(
    make("header", {},
      button("−", "Smaller", smaller),
      button("+", "Larger", larger),
      button("All of it", "All of it", () => zoom(1)),
      button("Close", "Close", () => dialog.close())),
    room,
  );
  document.body.append(dialog);
  dialog.addEventListener("close", () => {
    // What was drawn anew meanwhile has taken its place.
    if (place?.isConnected) place.replaceWith(...content.children);
    content.replaceChildren();
    opener?.focus();
  });
  dialog.addEventListener("keydown", (event) => {
    const act = { "+": larger, "=": larger, "-": smaller, "−": smaller, 0: () => zoom(1) }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
  // A mouse drags it; what was dragged is no click on a map.
  let held = null;
  room.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse") held = [event.clientX, event.clientY, false];
  });
  room.addEventListener("pointermove", (event) => {
    if (!held || event.buttons === 0) return;
    const [right, down] = [event.clientX - held[0], event.clientY - held[1]];
    if (!held[2] && Math.hypot(right, down) < 5) return;
    held = [event.clientX, event.clientY, true];
    room.scrollBy(-right, -down);
  });
  room.addEventListener("click", (event) => {
    if (held?.[2]) event.stopPropagation();
    held = null;
  }, true);
  return {
    open(panel, from) {
      opener = from;
      place = document.createComment("in large");
      panel.replaceWith(place);
      content.replaceChildren(panel);
      dialog.showModal();
      zoom(1);
      room.focus();
    },
  };
})();

const enlargeable = (panel) => {
  const name = panel.querySelector("h4")?.textContent || panel.querySelector("svg")?.getAttribute("aria-label") || "picture";
  const label = `In large: ${name}`;
  const icon = draw("svg", { viewBox: "0 0 16 16", width: "16", height: "16", "aria-hidden": "true" });
  icon.append(draw("path", { d: "M9 2h5v5M14 2L9.5 6.5M7 14H2V9M2 14l4.5 -4.5", fill: "none", stroke: "currentColor", "stroke-width": "1.6" }));
  const button = make("button", { type: "button", class: "enlarge", "aria-label": label, title: label }, icon);
  button.addEventListener("click", () => zoomed.open(panel, button));
  panel.append(button);
  return panel;
};
