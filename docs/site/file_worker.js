// Browsers start no worker from file://. There the search, which knows no other way, runs in a hidden frame.
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(url) {
      super();
      this.waiting = [];
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      const script = document.createElement("script");
      script.src = url;
      const attach = () => {
        this.frame.contentWindow.postMessage = (data) => {
          const event = new MessageEvent("message", { data });
          this.dispatchEvent(event);
          if (this.onmessage) this.onmessage(event);
        };
        script.onload = () => {
          for (const data of this.waiting) this.deliver(data);
          this.waiting = null;
        };
        this.frame.contentDocument.body.append(script);
      };
      if (document.body) document.body.append(this.frame), attach();
      else addEventListener("DOMContentLoaded", () => (document.body.append(this.frame), attach()));
    }
    deliver(data) {
      this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data }));
    }
    postMessage(data) {
      if (this.waiting) this.waiting.push(data);
      else this.deliver(data);
    }
    terminate() {
      this.frame.remove();
    }
  };
}
