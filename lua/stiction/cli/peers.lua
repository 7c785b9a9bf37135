-- stiction peers: cases that other programs have run, side by side with them.
local peers = require "stiction.peers"

return function(options)
  return peers(options)
end
