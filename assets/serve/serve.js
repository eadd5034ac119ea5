document.getElementById("picture").src = "stream" + location.search;
